// The body of the thread that captures an angle sweep: the only one that touches bench and sink while it runs.
#pragma once

#include "devices/capture/angle_capture.h"
#include "devices/capture/capture_course.h"
#include "devices/capture/capture_loop.h"
#include "devices/capture/live_queue.h"
#include "devices/capture/reference_zero.h"
#include "devices/capture/stream_pass.h"

#include <optional>
#include <string>
#include <vector>

namespace straightedge::devices {

/// What controller and worker share.
struct CaptureShared : CaptureControl {
  LiveQueue queue;
};

class CaptureWorker : public CaptureLoop {
public:
  CaptureWorker(AngleBench bench, session::SampleSink& sink, CaptureCourse course, CaptureShared& shared);

private:
  void takeRequests() override;
  bool isDone() const override { return !m_course.next(); }
  Step<void> measureNext() override;
  void forgetPositions() override { m_standsAtDeg.reset(); }
  Result<void> commitSink() override { return m_sink.commit(); }
  double timeOffsetS() const override { return m_course.timeOffsetS; }
  void fillProgress(CaptureProgress& progress) override;

  Step<void> confirmZero();
  Step<TimedReading> readEncoder();
  Step<void> measurePoint(int index);
  Step<void> readOnce(int index, std::optional<double> temperatureC);
  Step<StreamedAngle> readAsRead();
  Step<StreamedAngle> readInterpolated();
  // Free-running: capture_stream.cpp
  Step<void> measureRun(PointRun run);
  Step<void> beginPass(const StreamPass& pass);
  Step<void> followPass(StreamPass& pass);
  Step<void> storeStream(const StreamBlock& block, StreamPass& pass);
  Step<void> recordGaps(const StreamBlock& block);
  std::string streamNote(const StreamPass& pass, std::optional<double> rateHz) const;
  /// The shaft comes to a point from so far away, always in the point's direction, so that play and hysteresis are
  /// those of that direction.
  static constexpr double takeUpDeg = 5.0;

  Step<void> approach(double angleDeg, int direction);
  Step<void> travelTo(double angleDeg);
  Step<void> waitForHand(const PlannedPoint& point);
  Step<void> store(std::vector<session::AngleSample> samples);

  AngleBench m_bench;
  session::SampleSink& m_sink;
  CaptureCourse m_course;
  CaptureShared& m_shared;
  ReferenceZero m_zero;
  int m_doneAtStart = 0;
  std::optional<double> m_standsAtDeg; ///< where the stage was sent last; unknown at first and after a pause
  int m_cameFrom = 0;                  ///< direction of that move
  std::int64_t m_samples = 0;
  std::string m_note; ///< CaptureProgress::note
};

} // namespace straightedge::devices
