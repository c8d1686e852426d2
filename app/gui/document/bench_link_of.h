// What the links to an angle bench and to a field bench do alike: connection, capture into the open session, one look
// at the queue per frame, the record beside the samples.
#pragma once

#include "app/gui/document/calibration_document.h"
#include "app/gui/document/capture_link.h"
#include "app/gui/document/capture_record.h"
#include "devices/capture/capture_control.h"

#include <QTimer>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace straightedge::gui {

/// `Kind` names the types Bench, Plan, Sample, Sink, Capture, Progress and Reader, and says how the session keeps
/// samples and record (see AngleCaptureKind). GUI thread; talks to instruments only through the capture thread, or a
/// reader while idle.
template <typename Kind>
class BenchLinkOf : public CaptureLink {
public:
  using Bench = typename Kind::Bench;
  using Plan = typename Kind::Plan;
  using Sample = typename Kind::Sample;
  using Progress = typename Kind::Progress;
  using Reader = typename Kind::Reader;

  bool isConnected() const override { return m_bench.clock != nullptr; }
  QString benchName() const override { return QString::fromStdString(m_bench.name); }
  void disconnectBench(); ///< stops a running capture first; what was captured stays

  /// Live reading while connected and not capturing; not of instruments that can be unplugged, which their owner reads.
  void setLiveReading(bool on);

  /// Starts capturing into the document's session. `resume` goes on with the plan after the committed samples.
  Result<void> startCapture(const Plan& plan, session::SweepRole role, bool resume) {
    return beginCapture(plan, role, resume, std::nullopt);
  }
  void pauseCapture();
  void resumeCapture();
  void stopCapture();
  void stopAndWait(); ///< before the session closes: ends the capture, commits, and returns when both are done
  /// The plan of a capture in the session that was begun and not carried out to the end; empty while capturing.
  std::optional<Plan> interruptedPlan(session::SweepRole role) const;
  /// Role and plan of the running or last capture.
  session::SweepRole captureRole() const { return m_role; }
  const Plan& capturePlan() const { return m_plan; }
  bool isCapturing() const override;
  const Progress& progress() const { return m_progress; }
  const std::vector<Sample>& liveSamples() const { return m_live; } ///< of the running or last capture

protected:
  BenchLinkOf(CalibrationDocument& document, QObject* parent);

  /// Errors (Usage): a capture is running.
  Result<void> checkFree() const;
  /// A bench that was checked; the one before goes.
  void take(const Bench& bench, std::shared_ptr<void> owner, std::vector<BenchInstrument> instruments);
  Result<void> beginCapture(const Plan& plan, session::SweepRole role, bool resume, std::optional<int> redo);
  void finishLife(); ///< for the destructor of the derived class, on whose parts reader and capture may call
  Reader* reader() const { return m_reader.get(); } ///< null while the idle bench is not read

  /// Its signals go on to the derived class's.
  virtual void connectReader(const Reader& reader) = 0;
  /// The last thing before the first sample: documents beside the samples, the bench that goes on with them.
  virtual Result<void> prepareCapture(session::Session& /*session*/, bool /*resume*/, std::size_t /*samplesAlready*/) {
    return {};
  }
  /// The capture has ended: the document takes the samples in.
  virtual void takeSamplesIn(session::SweepRole role) = 0;

  CalibrationDocument& m_calibration;
  std::shared_ptr<void> m_owner; ///< outlives everything below
  Bench m_bench;
  Plan m_plan;
  std::unique_ptr<typename Kind::Sink> m_sink; ///< outlives the capture
  std::unique_ptr<typename Kind::Capture> m_capture;

private:
  void onFrame();
  void endCapture();
  void onDocumentOpened();
  void updateLiveReading();

  bool m_liveWanted = false;
  std::unique_ptr<Reader> m_reader; ///< reads the idle bench in a thread of its own
  session::SweepRole m_role = session::SweepRole::Calibration;
  std::vector<Sample> m_live;
  Progress m_progress;
  std::string m_faultTold; ///< message; empty while there is none
  QTimer m_frame;
};

template <typename Kind>
BenchLinkOf<Kind>::BenchLinkOf(CalibrationDocument& document, QObject* parent)
    : CaptureLink(parent), m_calibration(document) {
  constexpr int framePeriodMs = 16; // one frame at 60 Hz
  m_frame.setInterval(framePeriodMs);
  m_frame.setTimerType(Qt::PreciseTimer);
  connect(&m_frame, &QTimer::timeout, this, [this] { onFrame(); });
  connect(&document, &CalibrationDocument::opened, this, [this] { onDocumentOpened(); });
}

template <typename Kind>
void BenchLinkOf<Kind>::finishLife() {
  m_frame.stop();
  m_reader.reset();
  m_capture.reset(); // stops, commits, joins
}

template <typename Kind>
Result<void> BenchLinkOf<Kind>::checkFree() const {
  if (isCapturing()) {
    return fail(ErrorKind::Usage, "the bench cannot be changed during a capture", "stop the capture first");
  }
  return {};
}

template <typename Kind>
void BenchLinkOf<Kind>::take(const Bench& bench, std::shared_ptr<void> owner,
                             std::vector<BenchInstrument> instruments) {
  m_reader.reset();
  m_capture.reset(); // of the bench before; it points to that bench's instruments
  m_bench = bench;
  m_owner = std::move(owner);
  m_instruments = std::move(instruments);
  updateLiveReading();
  emit connectionChanged();
}

template <typename Kind>
void BenchLinkOf<Kind>::disconnectBench() {
  stopAndWait();
  m_reader.reset();
  m_capture.reset();
  m_bench = {};
  m_instruments.clear();
  m_owner.reset();
  emit connectionChanged();
}

template <typename Kind>
void BenchLinkOf<Kind>::setLiveReading(bool on) {
  m_liveWanted = on;
  updateLiveReading();
}

template <typename Kind>
void BenchLinkOf<Kind>::updateLiveReading() {
  const bool ownerReads = m_bench.connection != nullptr;
  if (!m_liveWanted || !isConnected() || ownerReads || isCapturing()) {
    m_reader.reset();
  } else if (!m_reader) {
    m_reader = std::make_unique<Reader>(m_bench);
    connectReader(*m_reader);
  }
}

template <typename Kind>
Result<void> BenchLinkOf<Kind>::beginCapture(const Plan& plan, session::SweepRole role, bool resume,
                                             std::optional<int> redo) {
  session::Session* session = m_calibration.session();
  if (!isConnected()) {
    return fail(ErrorKind::Usage, "no bench is connected", "connect one in the step Connect");
  }
  if (isCapturing()) {
    return fail(ErrorKind::Usage, "a capture is already running", "stop it first");
  }
  if (session == nullptr) {
    return fail(ErrorKind::Usage, "no calibration is open", "start a new one or open a session");
  }
  if (Result<void> checked = devices::checkPlan(plan); !checked) {
    return checked;
  }
  std::vector<Sample> already;
  if (resume) {
    Result<std::vector<Sample>> committed = Kind::samples(*session, role);
    if (!committed) {
      return std::unexpected(std::move(committed.error()));
    }
    already = std::move(*committed);
  } else if (Result<void> cleared = session->clearSamples(role); !cleared) {
    return cleared;
  }
  m_reader.reset(); // from here the capture thread alone touches the instruments
  m_capture.reset();
  m_role = role;
  m_plan = plan;
  Result<void> begun = prepareCapture(*session, resume, already.size());
  if (begun) {
    begun = writeCaptureRecord(*session, role, {plan, false, describe()});
  }
  if (begun) {
    Result<std::unique_ptr<typename Kind::Sink>> sink = Kind::sink(*session, role);
    if (sink) {
      m_sink = std::move(*sink);
      m_capture = std::make_unique<typename Kind::Capture>(m_bench, *m_sink);
      begun = m_capture->start(plan, already);
    } else {
      begun = std::unexpected(std::move(sink.error()));
    }
  }
  if (!begun) {
    m_capture.reset();
    m_sink.reset();
    updateLiveReading();
    return begun;
  }
  if (redo) { // of a capture that is complete: it ends again after this
    m_capture->redo(*redo);
  }
  m_faultTold.clear();
  m_live = std::move(already);
  m_progress = m_capture->progress();
  m_progress.state = devices::CaptureState::Running; // what it has come to meanwhile is told with the first frame
  m_frame.start();
  emit samplesArrived(0);
  emit progressChanged();
  return {};
}

template <typename Kind>
void BenchLinkOf<Kind>::pauseCapture() {
  if (m_capture) {
    m_capture->pause();
  }
}

template <typename Kind>
void BenchLinkOf<Kind>::resumeCapture() {
  if (m_capture) {
    m_faultTold.clear();
    m_capture->resume();
  }
}

template <typename Kind>
void BenchLinkOf<Kind>::stopCapture() {
  if (m_capture) {
    m_capture->stop();
  }
}

template <typename Kind>
void BenchLinkOf<Kind>::stopAndWait() {
  if (!isCapturing()) {
    return;
  }
  m_capture->stop();
  m_capture->waitUntilDone();
  onFrame();
}

template <typename Kind>
std::optional<typename Kind::Plan> BenchLinkOf<Kind>::interruptedPlan(session::SweepRole role) const {
  const session::Session* session = std::as_const(m_calibration).session();
  if (session == nullptr || session->readOnly() || isCapturing()) {
    return std::nullopt;
  }
  const auto record = Kind::record(*session, role);
  if (!record || record->finished || Kind::sampleCount(*session, role).value_or(0) == 0) {
    return std::nullopt;
  }
  return record->plan;
}

template <typename Kind>
bool BenchLinkOf<Kind>::isCapturing() const {
  return m_capture != nullptr &&
         (m_progress.state == devices::CaptureState::Running || m_progress.state == devices::CaptureState::Paused);
}

template <typename Kind>
void BenchLinkOf<Kind>::onFrame() {
  if (!m_capture) {
    m_frame.stop();
    return;
  }
  // The state first: samples taken after it cannot be missed when it says that the capture has ended.
  m_progress = m_capture->progress();
  const std::vector<Sample> fresh = m_capture->takeNewSamples();
  if (!fresh.empty()) {
    const auto firstNew = static_cast<int>(m_live.size());
    m_live.insert(m_live.end(), fresh.begin(), fresh.end());
    emit samplesArrived(firstNew);
  }
  // Told once; again where it is another one, or came back: an instrument may be back and not be what it was.
  const std::string fault = m_progress.error ? m_progress.error->message() : std::string();
  if (std::exchange(m_faultTold, fault) != fault && !fault.empty()) {
    emit failed(QString::fromStdString(fault));
  }
  if (!isCapturing()) {
    endCapture();
    return;
  }
  emit progressChanged();
}

template <typename Kind>
void BenchLinkOf<Kind>::endCapture() {
  m_frame.stop();
  const bool finished = m_progress.state == devices::CaptureState::Finished;
  m_capture.reset(); // joins; the sink's connection is closed before anyone reads the session
  m_sink.reset();
  const session::SweepRole role = m_role;
  if (session::Session* session = m_calibration.session(); session != nullptr) {
    if (const Result<void> noted = writeCaptureRecord(*session, role, {m_plan, finished, describe()}); !noted) {
      emit failed(QString::fromStdString(noted.error().message()));
    }
  }
  takeSamplesIn(role);
  updateLiveReading();
  emit progressChanged();
  emit captureEnded(role);
}

template <typename Kind>
void BenchLinkOf<Kind>::onDocumentOpened() {
  // Samples of the session that was open before; the shell has ended its capture by stopAndWait().
  m_live.clear();
  m_progress = {};
  emit samplesArrived(0);
  emit progressChanged();
}

} // namespace straightedge::gui
