// Runs a plan on a bench in a thread of its own: samples go to the session's sink and, as frozen blocks, into a bounded
// queue.
#pragma once

#include "core/session/sample_sink.h"
#include "devices/capture/angle_plan.h"
#include "devices/capture/capture_control.h"
#include "devices/instruments/angle_instruments.h"

#include <memory>
#include <vector>

namespace straightedge::devices {

/// Owns the capture thread. All members may be called from one controlling thread (the GUI's or main's).
/// The bench and the sink must outlive the capture.
class AngleCapture {
public:
  AngleCapture(AngleBench bench, session::SampleSink& sink);
  ~AngleCapture(); ///< stops and joins
  AngleCapture(const AngleCapture&) = delete;
  AngleCapture& operator=(const AngleCapture&) = delete;

  /// Starts from the first point, or goes on after `already` samples of the same plan (resume after a crash or stop).
  Result<void> start(const AnglePlan& plan, const std::vector<session::AngleSample>& already = {});
  void pause();
  void resume();
  void stop(); ///< ends the sweep after the current reading; committed samples stay
  /// Measures this planned point again, as a further attempt: next while running, by itself after the sweep has
  /// finished, first of all where it is asked for before start(). A number that is in no plan is ignored.
  void redo(int pointIndex);
  /// Blocks until the sweep has ended or a fault paused it; for the command line and tests.
  void waitUntilDone();

  CaptureProgress progress() const;
  /// Moves out every sample that arrived since the last call. Called once per frame by the GUI.
  std::vector<session::AngleSample> takeNewSamples();

private:
  struct Impl;
  std::unique_ptr<Impl> m_impl;
};

} // namespace straightedge::devices
