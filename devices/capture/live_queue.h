// Bounded queue of frozen blocks between the capture thread and whoever shows the samples.
#pragma once

#include "core/session/sample_sink.h"

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

namespace straightedge::devices {

/// Thread: push() from the capture thread, the rest from the controlling one. Never blocks the capture: a block that
/// does not fit is left out and counted; the session's sink has it all the same.
template <typename Sample>
class LiveQueueOf {
public:
  static constexpr std::size_t defaultCapacity = 131072; ///< samples: 13 s at 10,000 a second

  explicit LiveQueueOf(std::size_t capacity = defaultCapacity) : m_capacity(capacity) {}

  void push(std::vector<Sample> block) {
    const std::scoped_lock lock(m_mutex);
    if (m_queued + block.size() > m_capacity) {
      m_lost += static_cast<std::int64_t>(block.size());
      return;
    }
    m_queued += block.size();
    m_blocks.push_back(std::move(block));
  }

  std::vector<Sample> takeAll() {
    std::vector<std::vector<Sample>> blocks;
    {
      const std::scoped_lock lock(m_mutex);
      blocks.swap(m_blocks);
      m_queued = 0;
    }
    if (blocks.empty()) {
      return {};
    }
    std::vector<Sample> all = std::move(blocks.front());
    for (std::size_t i = 1; i < blocks.size(); ++i) {
      all.insert(all.end(), blocks[i].begin(), blocks[i].end());
    }
    return all;
  }

  std::int64_t lost() const {
    const std::scoped_lock lock(m_mutex);
    return m_lost;
  }

private:
  const std::size_t m_capacity;
  mutable std::mutex m_mutex;
  std::vector<std::vector<Sample>> m_blocks;
  std::size_t m_queued = 0;
  std::int64_t m_lost = 0;
};
using LiveQueue = LiveQueueOf<session::AngleSample>;

} // namespace straightedge::devices
