#include "app/gui/document/bench_link.h"

#include "app/gui/document/angle_document.h"
#include "app/gui/document/capture_record.h"
#include "app/gui/document/captured_sweep.h"
#include "app/gui/document/live_reader.h"

#include <QTimer>

#include <algorithm>

namespace straightedge::gui {

namespace {

// One frame at 60 Hz.
constexpr int framePeriodMs = 16;

QString identityLine(const BenchInstrument& instrument) {
  QString line = instrument.role + QStringLiteral(": ") + QString::fromStdString(instrument.identity.model);
  if (!instrument.identity.serial.empty()) {
    line += QStringLiteral(", serial ") + QString::fromStdString(instrument.identity.serial);
  }
  return line;
}

/// The session has all samples; the live display may have lost some to a full queue.
std::vector<session::AngleSample> committedSamples(AngleDocument& document, session::SweepRole role,
                                                   const std::vector<session::AngleSample>& live) {
  const session::Session* session = document.session();
  return session == nullptr ? live : session->angleSamples(role).value_or(live);
}

bool isActive(devices::CaptureState state) {
  return state == devices::CaptureState::Running || state == devices::CaptureState::Paused;
}

} // namespace

struct BenchLink::Impl {
  explicit Impl(AngleDocument& openDocument) : document(openDocument) {}

  AngleDocument& document;
  devices::SimulatedAngleSettings settings;
  std::shared_ptr<void> owner; ///< outlives everything below
  devices::AngleBench bench;
  std::vector<BenchInstrument> instruments;
  bool simulated = false;
  bool liveWanted = false;
  std::unique_ptr<LiveReader> reader;

  session::SweepRole role = session::SweepRole::Calibration;
  devices::AnglePlan plan;
  std::unique_ptr<session::SampleSink> sink; ///< outlives the capture
  std::unique_ptr<devices::AngleCapture> capture;
  std::vector<session::AngleSample> live;
  devices::CaptureProgress progress;
  bool faultShown = false;
  QTimer frame;
};

BenchLink::BenchLink(AngleDocument& document, QObject* parent)
    : QObject(parent), m_impl(std::make_unique<Impl>(document)) {
  m_impl->frame.setInterval(framePeriodMs);
  m_impl->frame.setTimerType(Qt::PreciseTimer);
  connect(&m_impl->frame, &QTimer::timeout, this, &BenchLink::onFrame);
  connect(&document, &AngleDocument::opened, this, &BenchLink::onDocumentOpened);
}

BenchLink::~BenchLink() {
  m_impl->frame.stop();
  m_impl->reader.reset();
  m_impl->capture.reset(); // stops, commits, joins
}

bool BenchLink::isConnected() const { return m_impl->bench.sensor != nullptr; }

QString BenchLink::benchName() const { return QString::fromStdString(m_impl->bench.name); }

QString BenchLink::describe() const {
  QStringList lines;
  for (const BenchInstrument& instrument : m_impl->instruments) {
    lines << identityLine(instrument);
  }
  return lines.join(QLatin1Char('\n'));
}

std::vector<BenchInstrument> BenchLink::instruments() const { return m_impl->instruments; }

Result<void> BenchLink::connectSimulated(const devices::SimulatedAngleSettings& settings) {
  if (isCapturing()) {
    return fail(ErrorKind::Usage, "the bench cannot be changed during a capture", "stop the capture first");
  }
  auto simulated = std::make_shared<devices::SimulatedAngleBench>(settings);
  const devices::AngleBench bench = simulated->bench();
  m_impl->settings = settings;
  return useBench(bench, std::move(simulated), true);
}

Result<void> BenchLink::connectBench(devices::AngleBench bench, std::shared_ptr<void> owner) {
  return useBench(std::move(bench), std::move(owner), false);
}

Result<void> BenchLink::useBench(devices::AngleBench bench, std::shared_ptr<void> owner, bool simulated) {
  if (isCapturing()) {
    return fail(ErrorKind::Usage, "the bench cannot be changed during a capture", "stop the capture first");
  }
  if (bench.sensor == nullptr || bench.reference == nullptr || bench.clock == nullptr) {
    return fail(ErrorKind::Usage, "the bench has no " + std::string(bench.sensor == nullptr ? "sensor" : "reference"),
                "choose an instrument for it");
  }
  m_impl->reader.reset();
  m_impl->capture.reset(); // of the bench before; it points to that bench's instruments
  m_impl->bench = bench;
  m_impl->simulated = simulated;
  m_impl->owner = std::move(owner);
  m_impl->instruments = {{tr("Sensor under calibration"), bench.sensor->identity()},
                         {tr("Reference encoder"), bench.reference->identity()}};
  if (bench.stage != nullptr) {
    m_impl->instruments.push_back({tr("Rotary stage"), bench.stage->identity()});
  }
  updateLiveReading();
  emit connectionChanged();
  return {};
}

void BenchLink::disconnectBench() {
  stopAndWait();
  m_impl->reader.reset();
  m_impl->capture.reset();
  m_impl->bench = {};
  m_impl->instruments.clear();
  m_impl->owner.reset();
  emit connectionChanged();
}

bool BenchLink::isSimulated() const { return isConnected() && m_impl->simulated; }

bool BenchLink::hasStage() const { return m_impl->bench.stage != nullptr; }

const devices::SimulatedAngleSettings& BenchLink::simulatedSettings() const { return m_impl->settings; }

void BenchLink::setLiveReading(bool on) {
  m_impl->liveWanted = on;
  updateLiveReading();
}

void BenchLink::updateLiveReading() {
  const bool ownerReads = m_impl->bench.connection != nullptr;
  const bool wanted = m_impl->liveWanted && isConnected() && !ownerReads && !isCapturing();
  if (!wanted) {
    m_impl->reader.reset();
    return;
  }
  if (m_impl->reader) {
    return;
  }
  m_impl->reader = std::make_unique<LiveReader>(m_impl->bench);
  connect(m_impl->reader.get(), &LiveReader::reading, this, &BenchLink::liveReading);
  connect(m_impl->reader.get(), &LiveReader::failed, this, &BenchLink::failed);
}

bool BenchLink::canMoveShaft() const { return m_impl->reader != nullptr && m_impl->bench.stage != nullptr; }

void BenchLink::moveShaftTo(double encoderDeg) {
  if (canMoveShaft()) {
    m_impl->reader->moveShaftTo(encoderDeg);
  }
}

Result<void> BenchLink::startCapture(const devices::AnglePlan& plan, session::SweepRole role, bool resume) {
  return beginCapture(plan, role, resume, std::nullopt);
}

Result<void> BenchLink::beginCapture(const devices::AnglePlan& plan, session::SweepRole role, bool resume,
                                     std::optional<int> redo) {
  session::Session* session = m_impl->document.session();
  if (!isConnected()) {
    return fail(ErrorKind::Usage, "no bench is connected", "connect one in the step Connect");
  }
  if (isCapturing()) {
    return fail(ErrorKind::Usage, "a capture is already running", "stop it first");
  }
  if (session == nullptr) {
    return fail(ErrorKind::Usage, "no calibration is open", "start a new one or open a session");
  }
  if (const Result<void> checked = devices::checkPlan(plan); !checked) {
    return checked;
  }
  std::vector<session::AngleSample> already;
  if (resume) {
    Result<std::vector<session::AngleSample>> committed = session->angleSamples(role);
    if (!committed) {
      return std::unexpected(committed.error());
    }
    already = std::move(*committed);
  } else if (const Result<void> cleared = session->clearSamples(role); !cleared) {
    return cleared;
  }
  if (const Result<void> noted = writeCaptureRecord(*session, role, {plan, false, describe()}); !noted) {
    return noted;
  }
  Result<std::unique_ptr<session::SampleSink>> sink = session->angleSink(role);
  if (!sink) {
    return std::unexpected(sink.error());
  }
  m_impl->reader.reset(); // from here the capture thread alone touches the instruments
  m_impl->capture.reset();
  m_impl->sink = std::move(*sink);
  m_impl->capture = std::make_unique<devices::AngleCapture>(m_impl->bench, *m_impl->sink);
  m_impl->role = role;
  m_impl->plan = plan;
  m_impl->faultShown = false;
  m_impl->live = already;
  if (const Result<void> started = m_impl->capture->start(plan, already); !started) {
    m_impl->capture.reset();
    m_impl->sink.reset();
    updateLiveReading();
    return started;
  }
  if (redo) { // of a sweep that is complete: it ends again after this point
    m_impl->capture->redo(*redo);
  }
  m_impl->progress = m_impl->capture->progress();
  m_impl->frame.start();
  emit samplesArrived(0);
  emit progressChanged();
  return {};
}

void BenchLink::pauseCapture() {
  if (m_impl->capture) {
    m_impl->capture->pause();
  }
}

void BenchLink::resumeCapture() {
  if (m_impl->capture) {
    m_impl->faultShown = false;
    m_impl->capture->resume();
  }
}

void BenchLink::stopCapture() {
  if (m_impl->capture) {
    m_impl->capture->stop();
  }
}

void BenchLink::stopAndWait() {
  if (!isCapturing()) {
    return;
  }
  m_impl->capture->stop();
  m_impl->capture->waitUntilDone();
  onFrame();
}

std::optional<devices::AnglePlan> BenchLink::interruptedPlan(session::SweepRole role) const {
  const session::Session* session = m_impl->document.session();
  if (session == nullptr || session->readOnly() || isCapturing()) {
    return std::nullopt;
  }
  const std::optional<CaptureRecord> record = readCaptureRecord(*session, role);
  if (!record || record->finished || session->angleSampleCount(role).value_or(0) == 0) {
    return std::nullopt;
  }
  return record->plan;
}

session::SweepRole BenchLink::captureRole() const { return m_impl->role; }

const devices::AnglePlan& BenchLink::capturePlan() const { return m_impl->plan; }

void BenchLink::redoPoint(int pointIndex) {
  if (isCapturing()) {
    m_impl->capture->redo(pointIndex);
    return;
  }
  const session::Session* session = m_impl->document.session();
  if (session == nullptr) {
    return;
  }
  const std::optional<CaptureRecord> record = readCaptureRecord(*session, session::SweepRole::Calibration);
  if (!record) {
    emit failed(tr("This sweep was not captured on a bench; a single point cannot be measured again."));
    return;
  }
  if (const Result<void> begun = beginCapture(record->plan, session::SweepRole::Calibration, true, pointIndex);
      !begun) {
    emit failed(QString::fromStdString(begun.error().message()));
  }
}

bool BenchLink::isCapturing() const { return m_impl->capture != nullptr && isActive(m_impl->progress.state); }

devices::CaptureProgress BenchLink::progress() const { return m_impl->progress; }

const std::vector<session::AngleSample>& BenchLink::liveSamples() const { return m_impl->live; }

void BenchLink::onFrame() {
  if (!m_impl->capture) {
    m_impl->frame.stop();
    return;
  }
  // The state first: samples taken after it cannot be missed when it says that the capture has ended.
  const devices::CaptureProgress progress = m_impl->capture->progress();
  const std::vector<session::AngleSample> fresh = m_impl->capture->takeNewSamples();
  m_impl->progress = progress;
  if (!fresh.empty()) {
    const auto firstNew = static_cast<int>(m_impl->live.size());
    m_impl->live.insert(m_impl->live.end(), fresh.begin(), fresh.end());
    emit samplesArrived(firstNew);
  }
  if (!progress.error) {
    m_impl->faultShown = false; // the instrument is back, and may leave again
  } else if (!m_impl->faultShown) {
    m_impl->faultShown = true;
    emit failed(QString::fromStdString(progress.error->message()));
  }
  if (!isActive(progress.state)) {
    endCapture();
    return;
  }
  emit progressChanged();
}

void BenchLink::endCapture() {
  m_impl->frame.stop();
  const bool finished = m_impl->progress.state == devices::CaptureState::Finished;
  m_impl->capture.reset(); // joins; the sink's connection is closed before anyone reads the session
  m_impl->sink.reset();
  const session::SweepRole role = m_impl->role;
  if (session::Session* session = m_impl->document.session(); session != nullptr) {
    const Result<void> noted = writeCaptureRecord(*session, role, {m_impl->plan, finished, describe()});
    if (!noted) {
      emit failed(QString::fromStdString(noted.error().message()));
    }
  }
  if (role == session::SweepRole::Calibration) {
    m_impl->document.reloadSweepFromSession();
  } else {
    m_impl->document.setVerificationSweep(capturedSweep(committedSamples(m_impl->document, role, m_impl->live)));
  }
  updateLiveReading();
  emit progressChanged();
  emit captureEnded(role);
}

void BenchLink::onDocumentOpened() {
  // Samples of the session that was open before; the shell has ended its capture by stopAndWait().
  m_impl->live.clear();
  m_impl->progress = {};
  emit samplesArrived(0);
  emit progressChanged();
}

} // namespace straightedge::gui
