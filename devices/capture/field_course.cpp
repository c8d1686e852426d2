#include "devices/capture/field_course.h"

#include "core/field/names.h"

#include <algorithm>
#include <string>

namespace straightedge::devices {

namespace {

template <typename T>
std::optional<int> number(const std::optional<T>& value) {
  return value ? std::optional(static_cast<int>(*value)) : std::nullopt;
}

} // namespace

Result<FieldCourse> FieldCourse::make(const FieldPlan& plan, const std::vector<session::FieldSample>& already) {
  if (auto checked = checkPlan(plan); !checked) {
    return std::unexpected(checked.error());
  }
  FieldCourse course;
  course.m_plan = plan;
  for (const FieldStage& stage : plan.stages) {
    State state;
    state.points = plannedPoints(stage);
    course.startOver(state);
    course.m_states.push_back(std::move(state));
  }
  for (const session::FieldSample& sample : already) {
    const bool known = sample.stage >= 0 && sample.stage < course.stages() && sample.point >= 0 &&
                       sample.point < course.pointsPlanned(sample.stage);
    const FieldStage* stage = known ? &course.stage(sample.stage) : nullptr;
    if (stage == nullptr || sample.step != static_cast<int>(stage->step) || sample.axis != number(stage->axis) ||
        sample.orientation != number(stage->orientation)) {
      return fail(ErrorKind::Usage, "sample " + std::to_string(sample.sequence) + " does not belong to this plan",
                  "go on with the plan that the campaign was begun with, or start it over", "capture plan");
    }
    State& state = course.stateOf(sample.stage);
    if (sample.attempt > state.attempt) {
      course.startOver(state);
      state.attempt = sample.attempt;
    }
    if (sample.attempt == state.attempt) {
      course.noteRow(sample.stage, sample.locked);
      if (isSweep(*stage) || sample.locked) {
        course.rowTaken({sample.stage, sample.point});
      }
    }
    course.nextSequence = std::max(course.nextSequence, sample.sequence + 1);
    course.timeOffsetS = std::max(course.timeOffsetS, sample.timeS);
  }
  return course;
}

void FieldCourse::startOver(State& state) {
  state.any = false;
  state.everLocked = false;
  state.rows.assign(state.points.size(), 0);
  state.done.assign(state.points.size(), false);
}

const FieldPoint& FieldCourse::point(FieldTask task) const {
  return stateOf(task.stage).points[static_cast<std::size_t>(task.point)];
}

int FieldCourse::pointsPlanned(int stage) const { return static_cast<int>(stateOf(stage).points.size()); }

int FieldCourse::pointsDone(int stage) const {
  const State& state = stateOf(stage);
  return static_cast<int>(std::count(state.done.begin(), state.done.end(), true));
}

int FieldCourse::planned() const {
  int points = 0;
  for (int stage = 0; stage < stages(); ++stage) {
    points += skipped(stage) ? 0 : pointsPlanned(stage);
  }
  return points;
}

int FieldCourse::done() const {
  int points = 0;
  for (int stage = 0; stage < stages(); ++stage) {
    points += skipped(stage) ? 0 : pointsDone(stage);
  }
  return points;
}

double FieldCourse::remainingS() const {
  double seconds = 0.0;
  for (int i = 0; i < stages(); ++i) {
    if (!skipped(i)) {
      const double left = 1.0 - static_cast<double>(pointsDone(i)) / pointsPlanned(i);
      seconds += left * expectedS(m_plan, stage(i));
    }
  }
  return seconds;
}

std::optional<FieldTask> FieldCourse::nextOf(int stage) const {
  const State& state = stateOf(stage);
  const auto found = std::find(state.done.begin(), state.done.end(), false);
  if (skipped(stage) || found == state.done.end()) {
    return std::nullopt;
  }
  return FieldTask{stage, static_cast<int>(found - state.done.begin())};
}

std::optional<FieldTask> FieldCourse::next() const {
  for (const int stage : m_first) {
    if (const auto task = nextOf(stage)) {
      return task;
    }
  }
  for (int stage = 0; stage < stages(); ++stage) {
    if (const auto task = nextOf(stage)) {
      return task;
    }
  }
  return std::nullopt;
}

int FieldCourse::rowsTaken(FieldTask task) const {
  return stateOf(task.stage).rows[static_cast<std::size_t>(task.point)];
}

void FieldCourse::rowTaken(FieldTask task) {
  State& state = stateOf(task.stage);
  const auto point = static_cast<std::size_t>(task.point);
  state.done[point] = ++state.rows[point] >= stage(task.stage).rows;
}

void FieldCourse::noteRow(int stage, bool locked) {
  State& state = stateOf(stage);
  state.any = true;
  state.everLocked = state.everLocked || locked;
}

void FieldCourse::giveUp(FieldTask task) { stateOf(task.stage).done[static_cast<std::size_t>(task.point)] = true; }

void FieldCourse::redo(int stage) {
  if (stage < 0 || stage >= stages()) {
    return;
  }
  State& state = stateOf(stage);
  state.attempt += state.any ? 1 : 0;
  startOver(state);
  m_plan.stages[static_cast<std::size_t>(stage)].skipped = false;
  std::erase(m_first, stage);
  m_first.push_front(stage);
}

void FieldCourse::skip(int stage, bool skipped) {
  if (stage >= 0 && stage < stages()) {
    m_plan.stages[static_cast<std::size_t>(stage)].skipped = skipped;
  }
}

} // namespace straightedge::devices
