#include "app/gui/steps/connect_presenter.h"

#include "app/gui/document/angle_document.h"
#include "core/angle/angles.h"

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

} // namespace

ConnectPresenter::ConnectPresenter(AngleDocument& document, BenchLink& bench, QObject* parent)
    : QObject(parent), m_document(document), m_bench(bench) {
  connect(&bench, &BenchLink::connectionChanged, this, [this] {
    m_opened = std::exchange(m_opening, nullptr); // null where it was connected by somebody else
    loseReading();
    emit connectionChanged();
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

QList<ConnectedInstrument> ConnectPresenter::instruments() const { return connectedInstruments(m_bench); }

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

void ConnectPresenter::loseReading() {
  m_reading.reset();
  m_differences.clear();
  m_steady = 0;
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
  return traceabilityLines(m_document.traceability(), QStringLiteral("°"));
}

std::optional<BenchIdentities> ConnectPresenter::identities() const {
  const std::vector<BenchInstrument> instruments = m_bench.instruments();
  if (instruments.size() < 2) {
    return std::nullopt;
  }
  return BenchIdentities{instruments[0].identity, instruments[1].identity};
}

bool ConnectPresenter::canTakeOverInstruments() const {
  const auto bench = identities();
  return bench && tellsMore(*bench, m_document.traceability());
}

void ConnectPresenter::takeOverInstruments() {
  if (canTakeOverInstruments()) {
    m_document.setTraceability(withIdentities(m_document.traceability(), *identities()));
  }
}

} // namespace straightedge::gui
