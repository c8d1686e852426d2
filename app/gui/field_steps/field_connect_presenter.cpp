#include "app/gui/field_steps/field_connect_presenter.h"

#include "app/gui/document/field_document.h"
#include "app/gui/field_steps/field_page_words.h"
#include "app/gui/figures/field_figure_parts.h"
#include "app/gui/figures/figure_parts.h"
#include "core/field/names.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace straightedge::gui {

namespace {

// 10 readings a second.
constexpr qsizetype fieldTraceLength = 200;
constexpr double fieldReadingsPerSecond = 10.0;
constexpr qsizetype fieldNoiseLength = 50;
constexpr qsizetype fieldNoiseLeast = 10;
const QString noValue = QStringLiteral("–");

QString fixedText(double value, int decimals, const QString& unit) {
  return withProperMinus(QString::number(value, 'f', decimals)) + unit;
}

QString optionalText(const std::optional<double>& value, int decimals, const QString& unit) {
  return value ? fixedText(*value, decimals, unit) : noValue;
}

} // namespace

FieldConnectPresenter::FieldConnectPresenter(FieldDocument& document, FieldBenchLink& bench, QObject* parent)
    : QObject(parent), m_document(document), m_bench(bench) {
  connect(&bench, &FieldBenchLink::connectionChanged, this, [this] {
    m_opened = std::exchange(m_opening, nullptr); // null where it was connected by somebody else
    loseReading();
    emit connectionChanged();
    emit traceabilityChanged();
  });
  connect(&bench, &FieldBenchLink::progressChanged, this, [this] { // comes once per frame
    if (m_bench.isCapturing() != m_wasCapturing) {
      m_wasCapturing = m_bench.isCapturing();
      emit connectionChanged();
    }
  });
  connect(&bench, &FieldBenchLink::liveReading, this, &FieldConnectPresenter::takeReading);
  connect(&bench, &FieldBenchLink::failed, this, &FieldConnectPresenter::setProblem);
  connect(&document, &FieldDocument::traceabilityChanged, this, &FieldConnectPresenter::traceabilityChanged);
  connect(&document, &FieldDocument::opened, this, &FieldConnectPresenter::traceabilityChanged);
}

void FieldConnectPresenter::report(const Result<void>& outcome) {
  setProblem(outcome ? QString() : fromText(outcome.error().message()));
}

void FieldConnectPresenter::connectSimulated(const devices::SimulatedFieldSettings& settings) {
  report(m_bench.connectSimulated(settings));
}

bool FieldConnectPresenter::useInstruments(const std::shared_ptr<devices::OpenedBench>& opened) {
  const Result<devices::FieldBench> bench = opened->fieldBench();
  m_opening = opened.get();
  const Result<void> connection = bench ? m_bench.connectBench(*bench, opened) : std::unexpected(bench.error());
  m_opening = nullptr;
  report(connection);
  return connection.has_value();
}

void FieldConnectPresenter::letGoOfInstruments() {
  if (m_opened != nullptr) {
    disconnectBench();
  }
}

void FieldConnectPresenter::disconnectBench() {
  m_bench.disconnectBench();
  setProblem({});
}

QString FieldConnectPresenter::statusText() const {
  if (!connected()) {
    return tr("No bench is connected. Choose its settings and connect it.");
  }
  return m_bench.isCapturing()
             ? tr("%1 is capturing; its settings are locked until the campaign ends.").arg(m_bench.benchName())
             : tr("%1 is connected.").arg(m_bench.benchName());
}

void FieldConnectPresenter::setProblem(const QString& problem) {
  if (problem != m_problem) {
    m_problem = problem;
    emit problemChanged();
  }
}

void FieldConnectPresenter::setShown(bool shown) { m_bench.setLiveReading(shown); }

void FieldConnectPresenter::loseReading() {
  m_reading.reset();
  m_trace = {};
  emit readingChanged();
}

void FieldConnectPresenter::takeReading(const FieldLiveReading& reading) {
  m_reading = reading;
  for (std::size_t axis = 0; axis < m_trace.size(); ++axis) {
    m_trace[axis].append(reading.overRange ? std::numeric_limits<double>::quiet_NaN() : reading.rawT[axis]);
    if (m_trace[axis].size() > fieldTraceLength) {
      m_trace[axis].removeFirst();
    }
  }
  emit readingChanged();
}

QString FieldConnectPresenter::axisText(field::Axis axis) const {
  if (!m_reading) {
    return noValue;
  }
  return m_reading->overRange ? tr("over range") : fixedText(m_reading->rawT[field::indexOf(axis)], 6, {});
}

QString FieldConnectPresenter::noiseText(field::Axis axis) const {
  const QList<double>& all = m_trace[field::indexOf(axis)];
  const qsizetype first = std::max<qsizetype>(1, all.size() - fieldNoiseLength);
  // From differences of neighbours: a field or a temperature that drifts slowly is no noise.
  double squares = 0.0;
  qsizetype count = 0;
  for (qsizetype i = first; i < all.size(); ++i) {
    const double difference = all[i] - all[i - 1];
    if (std::isfinite(difference)) {
      squares += difference * difference;
      ++count;
    }
  }
  if (count < fieldNoiseLeast) {
    return {};
  }
  return tr("1 σ %1").arg(microteslaText(std::sqrt(0.5 * squares / static_cast<double>(count)), 2));
}

QList<FieldConnectPresenter::Value> FieldConnectPresenter::values() const {
  const FieldLiveReading now = m_reading.value_or(FieldLiveReading{});
  QString reference = noValue;
  if (m_reading && m_bench.hasReference()) {
    reference = now.locked ? fixedText(*now.referenceT, 7, tr(" T")) : tr("not locked");
  }
  return {{QStringLiteral("reference"), tr("Reference"), reference},
          {QStringLiteral("pt100"), tr("PT100"), optionalText(now.pt100Ohm, 4, tr(" Ω"))},
          {QStringLiteral("electronics"), tr("Electronics"), optionalText(now.electronicsC, 2, tr(" °C"))},
          {QStringLiteral("probeChamber"), tr("Probe chamber"), optionalText(now.probeChamberC, 2, tr(" °C"))},
          {QStringLiteral("electronicsChamber"), tr("Electronics chamber"),
           optionalText(now.electronicsChamberC, 2, tr(" °C"))}};
}

PlotSpec FieldConnectPresenter::tracePlot() const {
  PlotSpec spec;
  spec.x.title = tr("Time before now (s)");
  spec.x.minimum = -static_cast<double>(fieldTraceLength) / fieldReadingsPerSecond;
  spec.x.maximum = 0.0;
  spec.x.tickStep = 5.0;
  spec.y.title = tr("Raw reading (mT)");
  if (m_trace[0].isEmpty()) {
    spec.y.minimum = -1.0;
    spec.y.maximum = 1.0;
  }
  for (const field::Axis axis : field::allAxes) {
    const QList<double>& readings = m_trace[field::indexOf(axis)];
    PlotSeries series =
        lineSeries(readings.isEmpty() ? QString() : tr("Axis %1").arg(axisLetter(axis)), axisColor(axis));
    series.x.reserve(readings.size());
    series.y.reserve(readings.size());
    for (qsizetype i = 0; i < readings.size(); ++i) {
      series.x.append(static_cast<double>(i - readings.size() + 1) / fieldReadingsPerSecond);
      series.y.append(1e3 * readings[i]);
    }
    spec.series.append(std::move(series));
  }
  return spec;
}

QString FieldConnectPresenter::traceabilitySummary() const {
  return traceabilityLines(m_document.traceability(), tr(" T"));
}

std::optional<BenchIdentities> FieldConnectPresenter::identities() const {
  const std::vector<BenchInstrument> instruments = m_bench.instruments();
  if (instruments.empty()) {
    return std::nullopt;
  }
  BenchIdentities bench{instruments[0].identity, std::nullopt};
  if (m_bench.hasReference()) {
    bench.reference = instruments[1].identity;
  }
  return bench;
}

bool FieldConnectPresenter::canTakeOverInstruments() const {
  const auto bench = identities();
  return bench && tellsMore(*bench, m_document.traceability());
}

void FieldConnectPresenter::takeOverInstruments() {
  if (canTakeOverInstruments()) {
    m_document.setTraceability(withIdentities(m_document.traceability(), *identities()));
  }
}

QString placementWords(devices::ProbePlacement placing) {
  if (placing == devices::ProbePlacement::ZeroChamber) {
    return FieldConnectPresenter::tr("in the zero-field chamber");
  }
  const auto name = field::orientationName(static_cast<field::Orientation>(placing));
  return FieldConnectPresenter::tr("in the magnet, %1 along the field")
      .arg(withProperMinus(QString::fromLatin1(name.data(), static_cast<qsizetype>(name.size()))));
}

} // namespace straightedge::gui
