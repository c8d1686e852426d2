// One deadline over several transfers.
#pragma once

#include "devices/transport/usbtmc_transport.h"

#include <algorithm>

namespace straightedge::devices {

class UsbTmcTransport::Deadline {
public:
  explicit Deadline(Milliseconds time) : m_end(Clock::now() + std::min(time, Milliseconds(std::chrono::hours(24)))) {}

  /// Rounded up: a part of a millisecond is still time.
  Milliseconds left() const { return std::max(Milliseconds(0), std::chrono::ceil<Milliseconds>(m_end - Clock::now())); }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point m_end;
};

} // namespace straightedge::devices
