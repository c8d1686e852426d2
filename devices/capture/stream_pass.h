// Which sector of a free-running sweep a streamed angle belongs to: bookkeeping only, no instruments, no threads.
#pragma once

#include "devices/capture/capture_course.h"

#include <optional>

namespace straightedge::devices {

/// One pass over a run of points. What is sampled on the way to the first sector and behind the last one belongs to
/// none. Jitter of the encoder at a border does not lead back into the sector before. By hand: the pass begins when the
/// shaft has stood before the first sector, and while it is turned back nothing counts until it has come on again.
class StreamPass {
public:
  /// `course` outlives this and learns which sectors were begun and passed.
  StreamPass(CaptureCourse& course, PointRun run, bool byHand);

  /// The point that a sample at this encoder angle belongs to.
  std::optional<int> place(double encoderDeg);

  bool begun() const { return m_sector >= m_run.first; } ///< the first sector was reached
  bool passed() const { return m_sector > m_run.last; }
  int direction() const { return m_direction; }
  double fromDeg() const { return m_fromDeg; } ///< where the first sector begins
  double toDeg() const;                        ///< where the last one ends

private:
  bool counts(double travelledDeg);

  CaptureCourse& m_course;
  PointRun m_run;
  bool m_byHand;
  int m_direction;
  double m_fromDeg;
  int m_sector;
  bool m_ready; ///< by hand: the shaft has stood before the first sector
  bool m_turnedBack = false;
  double m_farthestDeg = 0.0; ///< by hand: travelled
};

} // namespace straightedge::devices
