// Whether the instruments of a bench are there: what a capture asks after a fault.
#pragma once

#include "core/base/error.h"
#include "devices/transport/transport.h"

#include <optional>

namespace straightedge::devices {

/// Thread: the capture thread only.
class BenchConnection {
public:
  virtual ~BenchConnection() = default;

  /// Of the transport behind the last reading; none where that reading came, or where the instrument answered and its
  /// answer was the problem.
  virtual std::optional<TransportFault> lastFault() const = 0;

  /// Looks once for the instruments that left, and opens and sets up again those that are back: the same ones, by their
  /// serial numbers, at whatever port. True: all are there. Errors (Instrument): one is back and cannot be used.
  virtual Result<bool> restore() = 0;
};

} // namespace straightedge::devices
