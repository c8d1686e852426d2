// A sink that keeps samples in memory and can be told to fail.
#pragma once

#include "core/session/sample_sink.h"

#include <mutex>
#include <optional>
#include <vector>

namespace straightedge::tests {

/// Thread: append and commit from the capture thread, the rest from the test's.
class MemorySink : public session::SampleSink {
public:
  Result<void> append(std::span<const session::AngleSample> samples) override {
    const std::scoped_lock lock(m_mutex);
    if (m_failAfter && m_appended + samples.size() > *m_failAfter) {
      return fail(ErrorKind::Storage, "the disk is full", "free some space", "test.sedge");
    }
    m_appended += samples.size();
    m_pending.insert(m_pending.end(), samples.begin(), samples.end());
    return {};
  }
  Result<void> recordGap(const session::SampleGap& gap) override {
    const std::scoped_lock lock(m_mutex);
    m_gaps.push_back(gap);
    return {};
  }
  Result<void> commit() override {
    const std::scoped_lock lock(m_mutex);
    m_committed.insert(m_committed.end(), m_pending.begin(), m_pending.end());
    m_pending.clear();
    return {};
  }

  void failAfter(std::size_t samples) { m_failAfter = samples; } ///< before the capture starts
  std::vector<session::AngleSample> committed() const {
    const std::scoped_lock lock(m_mutex);
    return m_committed;
  }
  std::vector<session::SampleGap> gaps() const {
    const std::scoped_lock lock(m_mutex);
    return m_gaps;
  }

private:
  mutable std::mutex m_mutex;
  std::optional<std::size_t> m_failAfter;
  std::size_t m_appended = 0;
  std::vector<session::AngleSample> m_pending;
  std::vector<session::AngleSample> m_committed;
  std::vector<session::SampleGap> m_gaps;
};

} // namespace straightedge::tests
