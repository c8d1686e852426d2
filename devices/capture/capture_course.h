// What of a plan is measured and what is still to do: bookkeeping only, no instruments, no threads.
#pragma once

#include "core/session/sample_sink.h"
#include "devices/capture/angle_plan.h"

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace straightedge::devices {

/// A stretch of points that a free-running capture passes in one move.
struct PointRun {
  int first = 0;
  int last = 0;
};

/// In a free-running plan a point is the sector that begins at its angle and extends to the next one.
class CaptureCourse {
public:
  /// What is left of `plan` after `already`. A point that has all its readings is not measured again; one that has some
  /// gets the missing ones; a sector that was not passed to its end is passed again as a further attempt.
  /// Errors: Usage, where the plan is out of range or the samples belong to another plan.
  static Result<CaptureCourse> make(const AnglePlan& plan, const std::vector<session::AngleSample>& already);

  const AnglePlan& plan() const { return m_plan; }
  const PlannedPoint& point(int index) const { return m_points[static_cast<std::size_t>(index)]; }
  int planned() const { return static_cast<int>(m_points.size()); }
  int done() const { return planned() - static_cast<int>(m_todo.size()); }
  double stepDeg() const { return 360.0 / m_plan.pointsPerTurn; }

  std::optional<int> next() const;         ///< nothing: everything is measured
  std::optional<PointRun> nextRun() const; ///< the next points that follow each other in one direction
  int attempt(int index) const { return m_states[static_cast<std::size_t>(index)].attempt; }
  int readingsMissing(int index) const; ///< stepwise plans

  void readingTaken(int index); ///< stepwise: counts; the point is done with its last reading
  void sectorBegun(int index);  ///< free-running: the first sample of this pass
  void sectorDone(int index);
  void redo(int index); ///< next, as a further attempt; ignored where there is no such point

  std::int64_t nextSequence = 0;                   ///< number of the next sample
  double timeOffsetS = 0.0;                        ///< time of the last sample already there
  std::optional<session::AngleSample> lastAlready; ///< that sample

private:
  struct State {
    int attempt = 0;
    int readings = 0;         ///< of this attempt
    bool entered = false;     ///< free-running: samples of this attempt exist
    double nearestDeg = 0.0;  ///< how far into the sector the samples already there begin
    double farthestDeg = 0.0; ///< and end
  };
  void markDone(int index);
  bool passedToItsEnd(const State& state) const;

  AnglePlan m_plan;
  std::vector<PlannedPoint> m_points;
  std::vector<State> m_states;
  std::deque<int> m_todo;
};

} // namespace straightedge::devices
