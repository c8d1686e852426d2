// The rate that a stream really has, by the times of its samples.
#pragma once

#include "devices/instruments/angle_instruments.h"

#include <cstdint>
#include <optional>

namespace straightedge::devices {

/// Counts what was sampled, also what was lost on the way. One thread.
class StreamRate {
public:
  void add(const StreamBlock& block) {
    if (block.samples.empty()) {
      return;
    }
    if (!m_begun) {
      m_begun = true;
      m_firstS = block.samples.front().timeS;
      m_count = -1; // intervals, not samples
    } else {
      m_count += block.lost + block.rejected + block.unpaired;
    }
    m_count += static_cast<std::int64_t>(block.samples.size());
    const double passedS = block.samples.back().timeS - m_firstS;
    if (!m_hz && passedS >= 1.0) {
      m_hz = static_cast<double>(m_count) / passedS;
    }
  }

  /// Of the first second; not known before it has passed.
  std::optional<double> hz() const { return m_hz; }

private:
  bool m_begun = false;
  std::int64_t m_count = 0;
  double m_firstS = 0.0;
  std::optional<double> m_hz;
};

} // namespace straightedge::devices
