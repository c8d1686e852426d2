// Serial lines where the kernel made a tty: which there are (asked of libserialport), and the transport over one. The
// line itself is set up here and not by libserialport: its release 0.1.1 knows no pseudo terminals and no links such as
// /dev/serial/by-id, and its blocking read spins on a line that was hung up and then calls it a time-out.
#pragma once

#include "devices/transport/serial_settings.h"
#include "devices/transport/transport.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace straightedge::devices {

struct SerialPortInfo {
  std::string path;        ///< "/dev/ttyUSB0"
  std::string description; ///< as the system calls it; may be empty
  std::optional<std::uint16_t> vendorId;
  std::optional<std::uint16_t> productId;
  std::string usbSerial; ///< serial number of the USB device; may be empty
  std::string usbProduct;
};

/// The ports of this machine, in order of their paths. A machine without any gives an empty list, which is no error.
Result<std::vector<SerialPortInfo>> listSerialPorts();

/// Opens the port for this program alone and sets it up; what waits in it is thrown away. Pseudo terminals have no
/// control lines: there `dtr`, `rts` and `flow` RtsCts are without effect. Errors: Gone (no such port), AccessDenied,
/// Busy (another program has it), Unsupported (a setting), Failed. read(), readUntil(): Gone on a hang-up, after all
/// that came before it; TimedOut keeps what came for the next call.
TransportResult<std::unique_ptr<Transport>> openSerialPort(const std::string& path, const SerialSettings& settings);

} // namespace straightedge::devices
