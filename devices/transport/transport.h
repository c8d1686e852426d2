// A way to talk to an instrument: bytes out, bytes in, with a deadline. USBTMC, serial lines and recorded dialogues are
// behind it; what the bytes mean is the instrument driver's business.
#pragma once

#include "core/base/error.h"

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace straightedge::devices {

/// What went wrong on the way, beside the sentence for a person: decides whether it is tried again.
enum class TransportFault : std::uint8_t {
  AccessDenied, ///< no right to open the device
  Busy,         ///< another program has it open
  Gone,         ///< unplugged or switched off
  TimedOut,     ///< no answer within the deadline
  Stalled,      ///< the device refused the transfer; the line was cleared and may be used again
  Overflow,     ///< the device sent more than it announced
  Protocol,     ///< what came back breaks the protocol
  Unsupported,  ///< the transport or the device cannot do this
  Failed,       ///< anything else
};

struct TransportError {
  TransportFault fault = TransportFault::Failed;
  Error error; ///< kind Instrument; `where` names the instrument or the port
};

template <typename T>
using TransportResult = std::expected<T, TransportError>;

using Milliseconds = std::chrono::milliseconds;

/// Owns its device. Thread: one at a time, the capture thread while a capture runs. Every member may block up to its
/// deadline and says Gone when the device has left; it is never made up what was not received.
class Transport {
public:
  virtual ~Transport() = default;

  /// For messages and the console: "USBTMC 1bfa:0498 serial 0123", "/dev/ttyUSB0".
  virtual std::string name() const = 0;

  virtual TransportResult<void> write(std::string_view bytes, Milliseconds deadline) = 0;

  /// True where the device marks the end of each message (USBTMC); false on a line of bytes.
  virtual bool hasMessages() const { return false; }

  /// A whole message where the transport has messages (USBTMC); otherwise what is there, at least one byte.
  virtual TransportResult<std::string> read(Milliseconds deadline) = 0;

  /// Bytes up to and including `end`; keeps what comes after it for the next read.
  virtual TransportResult<std::string> readUntil(std::string_view end, Milliseconds deadline) = 0;

  /// Throws away whatever was sent and not read, on both sides, so that the next query is answered by its own reply.
  virtual TransportResult<void> clear() = 0;

  /// IEEE 488.2 status byte. Unsupported where the transport has none.
  virtual TransportResult<std::uint8_t> statusByte(Milliseconds deadline);
};

} // namespace straightedge::devices
