// What tests of field captures share: a quick bench and plan, and a sink in memory.
#pragma once

#include "devices/capture/field_capture.h"
#include "devices/simulated/simulated_field_bench.h"

#include <mutex>
#include <optional>
#include <vector>

namespace straightedge::tests {

/// Thread: append and commit from the capture thread, the rest from the test's.
class FieldMemorySink : public session::FieldSampleSink {
public:
  Result<void> append(std::span<const session::FieldSample> samples) override {
    const std::scoped_lock lock(m_mutex);
    if (m_failAfter && m_pending.size() + m_committed.size() + samples.size() > *m_failAfter) {
      return fail(ErrorKind::Storage, "the disk is full", "free some space", "test.sedge");
    }
    m_pending.insert(m_pending.end(), samples.begin(), samples.end());
    return {};
  }
  Result<void> recordGap(const session::SampleGap&) override { return {}; }
  Result<void> commit() override {
    const std::scoped_lock lock(m_mutex);
    m_committed.insert(m_committed.end(), m_pending.begin(), m_pending.end());
    m_pending.clear();
    return {};
  }
  void failAfter(std::size_t samples) { m_failAfter = samples; } ///< before the capture starts
  std::vector<session::FieldSample> committed() const {
    const std::scoped_lock lock(m_mutex);
    return m_committed;
  }

private:
  mutable std::mutex m_mutex;
  std::optional<std::size_t> m_failAfter;
  std::vector<session::FieldSample> m_pending;
  std::vector<session::FieldSample> m_committed;
};

inline devices::SimulatedFieldSettings virtualFieldBench() {
  devices::SimulatedFieldSettings settings;
  settings.realTime = false;
  return settings;
}

/// All stages with few rows.
inline devices::FieldPlan smallFieldPlan() {
  devices::FieldPlanShape shape;
  shape.fieldsT = {-2.0, -1.5, -1.0, -0.5, -0.1, 0.1, 0.5, 1.0, 1.5, 2.0};
  shape.rows = 4;
  shape.sweepRows = 40;
  shape.rowS = 6.0;
  return devices::makeFieldPlan(shape);
}

} // namespace straightedge::tests
