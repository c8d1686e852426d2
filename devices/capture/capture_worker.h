// The body of the capture thread: the only one that touches the bench and the sink while a sweep runs.
#pragma once

#include "devices/capture/angle_capture.h"
#include "devices/capture/capture_course.h"
#include "devices/capture/live_queue.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <expected>
#include <mutex>
#include <stop_token>
#include <vector>

namespace straightedge::devices {

/// What controller and worker share. `mutex` guards `progress` and `redoRequests`; `changed` tells of both directions.
struct CaptureShared {
  mutable std::mutex mutex;
  std::condition_variable_any changed;
  CaptureProgress progress;
  std::vector<int> redoRequests;
  std::atomic<bool> pauseRequested = false;
  LiveQueue queue;
};

class CaptureWorker {
public:
  CaptureWorker(AngleBench bench, session::SampleSink& sink, CaptureCourse course, CaptureShared& shared);

  /// Until the course is done, the sweep is stopped or the sink fails. May be run again, for a redo afterwards.
  void run(const std::stop_token& stop);

private:
  /// Why a measurement ended early. Without an error: pause or stop was asked for.
  struct Interruption {
    std::optional<Error> fault;
    bool ofStorage = false;
  };
  template <typename T>
  using Step = std::expected<T, Interruption>;
  template <typename T>
  static Step<T> fromInstrument(Result<T> outcome, const char* who);
  static Step<void> fromSink(Result<void> outcome);

  void begin();
  void takeRedoRequests();
  bool finish();                                                      ///< false: there is something to measure again
  bool rest(const std::stop_token& stop, std::optional<Error> fault); ///< paused; false: stopped meanwhile
  void end(CaptureState state, std::optional<Error> fault = std::nullopt);

  Step<void> measurePoint(int index);
  Step<void> readOnce(int index, std::optional<double> temperatureC);
  Step<void> measureRun(PointRun run);
  Step<bool> storeStream(const StreamBlock& block, PointRun run, int& sector); ///< true: passed the run's end
  Step<void> approach(double angleDeg, int direction);
  Step<void> travelTo(double angleDeg);
  Step<void> waitForHand(const PlannedPoint& point);
  Step<void> wait(double seconds);
  Step<void> checkInterruption() const;
  Step<void> store(std::vector<session::AngleSample> samples);
  Step<void> commitIfDue();
  Step<void> commit();
  double sampleTimeS(double benchTimeS) const;
  void publishProgress();

  AngleBench m_bench;
  session::SampleSink& m_sink;
  CaptureCourse m_course;
  CaptureShared& m_shared;
  std::stop_token m_stop;
  std::optional<double> m_startS; ///< bench clock at the first run
  int m_doneAtStart = 0;
  std::optional<double> m_standsAtDeg; ///< where the stage was sent last; unknown at first and after a pause
  int m_cameFrom = 0;                  ///< direction of that move
  std::int64_t m_samples = 0;
  std::optional<std::chrono::steady_clock::time_point> m_oldestUncommitted;
};

} // namespace straightedge::devices
