// What can go wrong on USB, told apart because each is mended differently.
#pragma once

#include "core/base/error.h"

#include <cstddef>
#include <cstdint>
#include <expected>

namespace straightedge::devices {

enum class UsbFault : std::uint8_t {
  AccessDenied, ///< the user has no right to open the device node
  Busy,         ///< another program or driver holds the interface
  Gone,         ///< unplugged, switched off, or another device sits at its address now
  TimedOut,     ///< the transfer did not end within its deadline and was taken back
  Stalled,      ///< the device refused: the endpoint stays halted until clearHalt()
  Overflow,     ///< the device sent more than it was asked for
  Unsupported,  ///< the device or the system cannot do this
  Cancelled,    ///< stopped by the stop token
  Failed,       ///< anything else
};

struct UsbError {
  UsbFault fault = UsbFault::Failed;
  Error error;           ///< kind Instrument (Cancelled: kind Cancelled); `where` names the device
  std::size_t bytes = 0; ///< what had been transferred before it went wrong
};

template <typename T>
using UsbResult = std::expected<T, UsbError>;

} // namespace straightedge::devices
