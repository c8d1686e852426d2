// How a serial line is set up, whoever drives it: the kernel's tty or CDC-ACM and FTDI through libusb.
#pragma once

#include <cstdint>

namespace straightedge::devices {

enum class Parity : std::uint8_t { None, Odd, Even };
enum class FlowControl : std::uint8_t { None, RtsCts, XonXoff };

struct SerialSettings {
  int baud = 115200; ///< bits per second
  int dataBits = 8;  ///< 5 to 8
  int stopBits = 1;  ///< 1 or 2
  Parity parity = Parity::None;
  FlowControl flow = FlowControl::None;
  bool dtr = true; ///< level after opening
  bool rts = true; ///< level after opening; without effect under FlowControl::RtsCts
  friend bool operator==(const SerialSettings&, const SerialSettings&) = default;
};

} // namespace straightedge::devices
