// What of a field campaign's plan is measured and what is still to do: bookkeeping only, no instruments, no threads.
#pragma once

#include "core/session/sample_sink.h"
#include "devices/capture/field_plan.h"

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace straightedge::devices {

/// The next plateau or sweep.
struct FieldTask {
  int stage = 0;
  int point = 0;
};

class FieldCourse {
public:
  /// What is left of `plan` after `already`. Of a plateau that has some of its locked rows the missing ones are
  /// measured, a sweep goes on at the row where it was left.
  /// Errors: Usage, where the plan is out of range or the samples belong to another plan.
  static Result<FieldCourse> make(const FieldPlan& plan, const std::vector<session::FieldSample>& already);

  const FieldPlan& plan() const { return m_plan; }
  const FieldStage& stage(int index) const { return m_plan.stages[static_cast<std::size_t>(index)]; }
  const FieldPoint& point(FieldTask task) const;
  int stages() const { return static_cast<int>(m_plan.stages.size()); }
  int planned() const; ///< points of all stages that are not skipped
  int done() const;
  int pointsDone(int stage) const;
  int pointsPlanned(int stage) const;
  double remainingS() const; ///< expected

  std::optional<FieldTask> next() const; ///< nothing: everything is measured
  int attempt(int stage) const { return m_states[static_cast<std::size_t>(stage)].attempt; }
  bool skipped(int stage) const { return m_plan.stages[static_cast<std::size_t>(stage)].skipped; }
  int rowsTaken(FieldTask task) const; ///< that count: locked ones of a plateau, all of a sweep

  void rowTaken(FieldTask task); ///< a row that counts; the point is done with its last
  void giveUp(FieldTask task);   ///< the point is done with what it has
  bool everLocked(int stage) const { return m_states[static_cast<std::size_t>(stage)].everLocked; }
  void noteRow(int stage, bool locked); ///< any row, also one that does not count
  void redo(int stage);                 ///< next, as a further attempt; a number that is in no plan is ignored
  void skip(int stage, bool skipped);   ///< likewise; a stage that is taken back in is measured where it was left

  std::int64_t nextSequence = 0; ///< number of the next sample
  double timeOffsetS = 0.0;      ///< time of the last sample already there

private:
  struct State {
    int attempt = 0;
    bool any = false; ///< samples of this attempt exist
    bool everLocked = false;
    std::vector<FieldPoint> points;
    std::vector<int> rows; ///< of each point, of this attempt
    std::vector<bool> done;
  };
  State& stateOf(int stage) { return m_states[static_cast<std::size_t>(stage)]; }
  const State& stateOf(int stage) const { return m_states[static_cast<std::size_t>(stage)]; }
  std::optional<FieldTask> nextOf(int stage) const;
  void startOver(State& state);

  FieldPlan m_plan;
  std::vector<State> m_states;
  std::deque<int> m_first; ///< stages that were asked for again, before all others
};

} // namespace straightedge::devices
