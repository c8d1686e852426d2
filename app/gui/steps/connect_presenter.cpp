#include "app/gui/steps/connect_presenter.h"

#include "app/gui/document/angle_document.h"
#include "core/angle/angles.h"
#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace straightedge::gui {

namespace {

// 20 readings a second.
constexpr int traceLength = 400;
constexpr double readingsPerSecond = 20.0;
constexpr int noiseLength = 100;
constexpr int noiseLeast = 10;
// An encoder that moves less than this between two readings stands still.
constexpr double standstillDeg = 0.005;
const QString dash = QStringLiteral("–");

QString angleText(double deg, int decimals) {
  return QString::number(deg, 'f', decimals).replace(QLatin1Char('-'), QChar(0x2212)) + QStringLiteral("°");
}

QString orNotStated(const std::string& text) {
  return text.empty() ? ConnectPresenter::tr("not stated") : QString::fromStdString(text);
}

/// "MODEL, serial SERIAL", as much of it as is stated.
QString joined(const std::string& first, const QString& word, const std::string& second) {
  const QString tail = second.empty() ? QString() : word + QLatin1Char(' ') + QString::fromStdString(second);
  return first.empty() && !second.empty()
             ? tail
             : orNotStated(first) + (tail.isEmpty() ? QString() : QStringLiteral(", ") + tail);
}

} // namespace

ConnectPresenter::ConnectPresenter(AngleDocument& document, BenchLink& bench, QObject* parent)
    : QObject(parent), m_document(document), m_bench(bench) {
  connect(&bench, &BenchLink::connectionChanged, this, [this] {
    m_opened = std::exchange(m_opening, nullptr); // null where it was connected by somebody else
    m_reading.reset();
    m_differences.clear();
    m_steady = 0;
    emit connectionChanged();
    emit readingChanged();
    emit traceabilityChanged();
  });
  connect(&bench, &BenchLink::progressChanged, this, [this] { // comes once per frame
    if (m_bench.isCapturing() != m_wasCapturing) {
      m_wasCapturing = m_bench.isCapturing();
      emit connectionChanged();
    }
  });
  connect(&bench, &BenchLink::liveReading, this, &ConnectPresenter::takeReading);
  connect(&bench, &BenchLink::failed, this, &ConnectPresenter::setProblem);
  connect(&document, &AngleDocument::traceabilityChanged, this, &ConnectPresenter::traceabilityChanged);
  connect(&document, &AngleDocument::opened, this, &ConnectPresenter::traceabilityChanged);
}

bool ConnectPresenter::connected() const { return m_bench.isConnected(); }

bool ConnectPresenter::mayChange() const { return !m_bench.isCapturing(); }

void ConnectPresenter::connectSimulated(const devices::SimulatedAngleSettings& settings) {
  const Result<void> connection = m_bench.connectSimulated(settings);
  setProblem(connection ? QString() : QString::fromStdString(connection.error().message()));
}

void ConnectPresenter::disconnectBench() {
  m_bench.disconnectBench();
  setProblem({});
}

bool ConnectPresenter::simulated() const { return m_bench.isSimulated(); }

bool ConnectPresenter::useInstruments(const std::shared_ptr<devices::OpenedBench>& opened) {
  const Result<devices::AngleBench> bench = opened->angleBench();
  m_opening = opened.get();
  const Result<void> connection = bench ? m_bench.connectBench(*bench, opened) : std::unexpected(bench.error());
  m_opening = nullptr;
  setProblem(connection ? QString() : QString::fromStdString(connection.error().message()));
  if (!connection) {
    return false;
  }
  if (devices::AnglePlan plan = m_document.plan(); !(plan.pairing == opened->saved().pairing)) {
    plan.pairing = opened->saved().pairing;
    m_document.setPlan(plan);
  }
  return true;
}

void ConnectPresenter::letGoOfInstruments() {
  if (m_opened != nullptr) {
    disconnectBench();
  }
}

QString ConnectPresenter::statusText() const {
  if (!connected()) {
    return tr("No bench is connected. Choose its settings and connect it.");
  }
  return m_bench.isCapturing()
             ? tr("%1 is capturing; its settings are locked until the sweep ends.").arg(m_bench.benchName())
             : tr("%1 is connected.").arg(m_bench.benchName());
}

QString ConnectPresenter::problem() const { return m_problem; }

void ConnectPresenter::setProblem(const QString& problem) {
  if (problem != m_problem) {
    m_problem = problem;
    emit problemChanged();
  }
}

QList<ConnectPresenter::Instrument> ConnectPresenter::instruments() const {
  QList<Instrument> list;
  for (const BenchInstrument& instrument : m_bench.instruments()) {
    list.append({instrument.role, QString::fromStdString(instrument.identity.model),
                 QString::fromStdString(instrument.identity.serial)});
  }
  return list;
}

void ConnectPresenter::setShown(bool shown) { m_bench.setLiveReading(shown); }

void ConnectPresenter::takeReading(double encoderDeg, double sensorDeg) {
  double difference = angle::wrap180(sensorDeg - encoderDeg);
  if (!m_differences.isEmpty()) { // continuous with the reading before
    difference = m_differences.back() + angle::wrap180(difference - m_differences.back());
  }
  const bool still = m_reading && std::abs(encoderDeg - m_reading->encoderDeg) < standstillDeg;
  m_steady = still ? std::min(m_steady + 1, noiseLength) : 1;
  m_reading = Reading{encoderDeg, sensorDeg};
  m_differences.append(difference);
  if (m_differences.size() > traceLength) {
    m_differences.removeFirst();
  }
  emit readingChanged();
}

std::optional<ConnectPresenter::Reading> ConnectPresenter::reading() const { return m_reading; }

QString ConnectPresenter::encoderText() const {
  return m_reading ? angleText(angle::wrap360(m_reading->encoderDeg), 4) : dash;
}

QString ConnectPresenter::sensorText() const { return m_reading ? angleText(m_reading->sensorDeg, 3) : dash; }

QString ConnectPresenter::differenceText() const {
  return m_reading ? angleText(angle::wrap180(m_reading->sensorDeg - m_reading->encoderDeg), 3) : dash;
}

QString ConnectPresenter::noiseText() const {
  if (m_steady < noiseLeast) {
    return dash;
  }
  const auto newest = m_differences.last(std::min<qsizetype>(m_steady, m_differences.size()));
  double mean = 0.0;
  for (const double value : newest) {
    mean += value;
  }
  mean /= static_cast<double>(newest.size());
  double squares = 0.0;
  for (const double value : newest) {
    squares += (value - mean) * (value - mean);
  }
  return angleText(std::sqrt(squares / static_cast<double>(newest.size() - 1)), 4);
}

PlotSpec ConnectPresenter::tracePlot() const {
  PlotSpec spec;
  spec.x.title = tr("Time before now (s)");
  spec.x.minimum = -static_cast<double>(traceLength) / readingsPerSecond;
  spec.x.maximum = 0.0;
  spec.x.tickStep = 5.0;
  spec.y.title = tr("Sensor − encoder (°)");
  PlotSeries series;
  series.color = SeriesColor::First;
  series.y = m_differences;
  for (qsizetype i = 0; i < m_differences.size(); ++i) {
    series.x.append(static_cast<double>(i - m_differences.size() + 1) / readingsPerSecond);
  }
  if (m_differences.isEmpty()) {
    spec.y.minimum = -1.0;
    spec.y.maximum = 1.0;
  }
  spec.series.append(series);
  return spec;
}

bool ConnectPresenter::canMoveShaft() const { return m_bench.canMoveShaft(); }

void ConnectPresenter::moveShaftTo(double encoderDeg) {
  if (m_reading) {
    m_bench.moveShaftTo(m_reading->encoderDeg + angle::wrap180(encoderDeg - m_reading->encoderDeg));
  }
}

QString ConnectPresenter::traceabilitySummary() const {
  const Traceability& stated = m_document.traceability();
  QStringList lines;
  const ReferenceInstrument& reference = stated.reference;
  lines << tr("Device: %1").arg(joined(stated.deviceModel, tr("serial"), stated.deviceSerial));
  lines << tr("Reference: %1").arg(joined(reference.model, tr("serial"), reference.serial));
  lines << tr("Certificate: %1").arg(joined(reference.certificate, tr("due"), reference.due));
  lines << (stated.reference.uncertainty > 0.0
                ? tr("Reference uncertainty: %1° (k = 2)")
                      .arg(QString::fromStdString(formatForPeople(stated.reference.uncertainty)))
                : tr("Reference uncertainty: not stated, so it counts as zero"));
  lines << tr("Operator: %1").arg(orNotStated(stated.operatorName));
  if (stated.ambientC) {
    lines << tr("Ambient temperature: %1 °C").arg(QString::fromStdString(formatForPeople(*stated.ambientC)));
  }
  return lines.join(QLatin1Char('\n'));
}

bool ConnectPresenter::canTakeOverInstruments() const {
  const std::vector<BenchInstrument> instruments = m_bench.instruments();
  if (instruments.size() < 2) {
    return false;
  }
  const Traceability& stated = m_document.traceability();
  const devices::InstrumentIdentity& sensor = instruments[0].identity;
  const devices::InstrumentIdentity& reference = instruments[1].identity;
  return stated.deviceModel != sensor.model || stated.deviceSerial != sensor.serial ||
         stated.reference.model != reference.model || stated.reference.serial != reference.serial;
}

void ConnectPresenter::takeOverInstruments() {
  if (!canTakeOverInstruments()) {
    return;
  }
  const std::vector<BenchInstrument> instruments = m_bench.instruments();
  Traceability stated = m_document.traceability();
  stated.deviceModel = instruments[0].identity.model;
  stated.deviceSerial = instruments[0].identity.serial;
  stated.reference.model = instruments[1].identity.model;
  stated.reference.serial = instruments[1].identity.serial;
  m_document.setTraceability(stated);
}

} // namespace straightedge::gui
