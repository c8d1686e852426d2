// Runs the plan of a field campaign on a bench in a thread of its own: rows go to the session's sink and, as frozen
// blocks, into a bounded queue.
#pragma once

#include "core/session/sample_sink.h"
#include "devices/capture/capture_control.h"
#include "devices/capture/field_plan.h"
#include "devices/instruments/field_bench.h"

#include <memory>
#include <string>
#include <vector>

namespace straightedge::devices {

/// What the capture does right now, within its stage.
enum class FieldAction : std::uint8_t {
  None,
  Placing,       ///< the carrier moves the probe
  SettingField,  ///< target: tesla
  SettlingProbe, ///< on its way to a temperature; target: °C
  SettlingElectronics,
  WaitingForLock, ///< rows come, the reference is not locked; target: tesla
  TakingRows,     ///< of a plateau; target: tesla
  SweepingProbe,  ///< target: °C that the chamber is sent to now
  SweepingElectronics
};

struct FieldStageProgress {
  int pointsDone = 0;
  int pointsPlanned = 0;
  int attempt = 0;
  bool skipped = false;
  int pointsGivenUp = 0; ///< of this run: the reference did not lock in time
};

/// A snapshot. `pointsDone` and `pointsPlanned` count plateaus and sweeps of all stages that are not skipped;
/// `remainingS` is the plan's expectation, on the bench's clock.
struct FieldCaptureProgress : CaptureProgress {
  int stage = -1;         ///< measured now; -1: none yet
  std::string waitingFor; ///< not empty: a person is to do this and confirm()
  FieldAction action = FieldAction::None;
  double target = 0.0; ///< of the action
  int rowsTaken = 0;   ///< of the present plateau or sweep; those that count
  std::vector<FieldStageProgress> stages;
};

/// Owns the capture thread; the same rules as AngleCapture's. All members may be called from one controlling thread.
/// The bench and the sink must outlive the capture.
class FieldCapture {
public:
  FieldCapture(FieldBench bench, session::FieldSampleSink& sink);
  ~FieldCapture(); ///< stops and joins
  FieldCapture(const FieldCapture&) = delete;
  FieldCapture& operator=(const FieldCapture&) = delete;

  /// Starts from the first stage, or goes on after `already` samples of the same plan.
  Result<void> start(const FieldPlan& plan, const std::vector<session::FieldSample>& already = {});
  void pause();
  void resume();
  void stop(); ///< ends after the current row; committed rows stay
  /// What FieldCaptureProgress::waitingFor asks for is done. Ignored where nothing is asked for.
  void confirm();
  /// Measures this stage again, as a further attempt: next while running (at once where it is being measured), by
  /// itself after the end.
  void redo(int stage);
  /// Leaves a stage out, at once where it is being measured or waits for a person, or takes it back in. Its rows stay.
  void skip(int stage, bool skipped = true);
  /// Blocks until the campaign has ended or a fault paused it; for the command line and tests.
  void waitUntilDone();

  FieldCaptureProgress progress() const;
  std::vector<session::FieldSample> takeNewSamples(); ///< every row that arrived since the last call

private:
  struct Impl;
  std::unique_ptr<Impl> m_impl;
};

} // namespace straightedge::devices
