#include "devices/capture/capture_course.h"

#include <algorithm>
#include <string>

namespace straightedge::devices {

Result<CaptureCourse> CaptureCourse::make(const AnglePlan& plan, const std::vector<session::AngleSample>& already) {
  if (auto checked = checkPlan(plan); !checked) {
    return std::unexpected(checked.error());
  }
  CaptureCourse course;
  course.m_plan = plan;
  course.m_points = plannedPoints(plan);
  course.m_states.resize(course.m_points.size());

  for (const session::AngleSample& sample : already) {
    const bool known = sample.point >= 0 && sample.point < course.planned();
    if (!known || sample.direction != course.point(sample.point).direction ||
        sample.turn != course.point(sample.point).turn) {
      return fail(ErrorKind::Usage, "sample " + std::to_string(sample.sequence) + " does not belong to this plan",
                  "go on with the plan that the sweep was begun with, or start it over", "capture plan");
    }
    State& state = course.m_states[static_cast<std::size_t>(sample.point)];
    if (sample.attempt > state.attempt) {
      state = State{.attempt = sample.attempt};
    }
    if (sample.attempt == state.attempt) {
      const PlannedPoint& start = course.point(sample.point);
      const double into = (sample.encoderDeg - start.encoderDeg) * start.direction;
      state.nearestDeg = state.readings == 0 ? into : std::min(state.nearestDeg, into);
      state.farthestDeg = state.readings == 0 ? into : std::max(state.farthestDeg, into);
      ++state.readings;
    }
    if (sample.sequence >= course.nextSequence) {
      course.lastAlready = sample;
    }
    course.nextSequence = std::max(course.nextSequence, sample.sequence + 1);
    course.timeOffsetS = std::max(course.timeOffsetS, sample.timeS);
  }

  const bool freeRunning = plan.sampleRateHz > 0.0;
  for (const PlannedPoint& point : course.m_points) {
    State& state = course.m_states[static_cast<std::size_t>(point.index)];
    const bool complete = freeRunning ? course.passedToItsEnd(state) : state.readings >= plan.averages;
    state.entered = state.readings > 0;
    if (!complete) {
      course.m_todo.push_back(point.index);
    }
  }
  return course;
}

bool CaptureCourse::passedToItsEnd(const State& state) const {
  if (state.readings < 2) {
    return false;
  }
  const double reach = 1.2 * (state.farthestDeg - state.nearestDeg) / (state.readings - 1);
  return state.nearestDeg <= reach && stepDeg() - state.farthestDeg <= reach;
}

std::optional<int> CaptureCourse::next() const { return m_todo.empty() ? std::nullopt : std::optional(m_todo.front()); }

std::optional<PointRun> CaptureCourse::nextRun() const {
  if (m_todo.empty()) {
    return std::nullopt;
  }
  PointRun run{m_todo.front(), m_todo.front()};
  for (std::size_t i = 1; i < m_todo.size(); ++i) {
    if (m_todo[i] != run.last + 1 || point(m_todo[i]).direction != point(run.first).direction) {
      break;
    }
    run.last = m_todo[i];
  }
  return run;
}

int CaptureCourse::readingsMissing(int index) const {
  return m_plan.averages - m_states[static_cast<std::size_t>(index)].readings;
}

void CaptureCourse::readingTaken(int index) {
  State& state = m_states[static_cast<std::size_t>(index)];
  ++state.readings;
  if (state.readings >= m_plan.averages) {
    markDone(index);
  }
}

void CaptureCourse::sectorBegun(int index) {
  State& state = m_states[static_cast<std::size_t>(index)];
  if (state.entered) {
    ++state.attempt; // begun before and not finished
  }
  state.entered = true;
}

void CaptureCourse::sectorDone(int index) { markDone(index); }

void CaptureCourse::markDone(int index) {
  if (const auto found = std::find(m_todo.begin(), m_todo.end(), index); found != m_todo.end()) {
    m_todo.erase(found);
  }
}

void CaptureCourse::redo(int index) {
  if (index < 0 || index >= planned()) {
    return;
  }
  State& state = m_states[static_cast<std::size_t>(index)];
  const bool freeRunning = m_plan.sampleRateHz > 0.0;
  if (!freeRunning && state.readings > 0) {
    ++state.attempt;
    state.readings = 0;
  } // a sector becomes a further attempt when it is entered again
  markDone(index);
  m_todo.push_front(index);
}

} // namespace straightedge::devices
