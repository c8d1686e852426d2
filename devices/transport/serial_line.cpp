#include "devices/transport/serial_line.h"

#include <asm/termbits.h> // struct termios2; <termios.h> declares another struct termios and must not be included here
#include <sys/ioctl.h>

namespace straightedge::devices {

namespace {

std::optional<tcflag_t> dataBitsFlag(int bits) {
  switch (bits) {
  case 5:
    return CS5;
  case 6:
    return CS6;
  case 7:
    return CS7;
  case 8:
    return CS8;
  default:
    return std::nullopt;
  }
}

tcflag_t parityFlags(Parity parity) {
  return parity == Parity::Odd ? PARENB | PARODD : parity == Parity::Even ? PARENB : 0U;
}

std::optional<std::string> setControlLines(int descriptor, const SerialSettings& settings) {
  unsigned lines = 0;
  if (::ioctl(descriptor, TIOCMGET, &lines) != 0) {
    return std::nullopt; // there are none
  }
  lines = settings.dtr ? lines | TIOCM_DTR : lines & ~static_cast<unsigned>(TIOCM_DTR);
  if (settings.flow != FlowControl::RtsCts) {
    lines = settings.rts ? lines | TIOCM_RTS : lines & ~static_cast<unsigned>(TIOCM_RTS);
  }
  if (::ioctl(descriptor, TIOCMSET, &lines) != 0) {
    return "to set DTR and RTS";
  }
  return std::nullopt;
}

} // namespace

std::optional<std::string> setUpLine(int descriptor, const SerialSettings& settings) {
  const auto dataBits = dataBitsFlag(settings.dataBits);
  if (!dataBits) {
    return std::to_string(settings.dataBits) + " data bits";
  }
  if (settings.stopBits != 1 && settings.stopBits != 2) {
    return std::to_string(settings.stopBits) + " stop bits";
  }
  if (settings.baud <= 0) {
    return std::to_string(settings.baud) + " baud";
  }
  termios2 line{};
  if (::ioctl(descriptor, TCGETS2, &line) != 0) {
    return "to tell its settings";
  }
  line.c_iflag = settings.flow == FlowControl::XonXoff ? IXON | IXOFF : 0U;
  line.c_oflag = 0;
  line.c_lflag = 0;
  line.c_cflag = CREAD | CLOCAL | HUPCL | *dataBits | parityFlags(settings.parity) | BOTHER | (BOTHER << IBSHIFT);
  line.c_cflag |= settings.stopBits == 2 ? CSTOPB : 0U;
  line.c_cflag |= settings.flow == FlowControl::RtsCts ? CRTSCTS : 0U;
  line.c_ispeed = line.c_ospeed = static_cast<speed_t>(settings.baud);
  line.c_cc[VMIN] = 1;
  line.c_cc[VTIME] = 0;
  if (::ioctl(descriptor, TCSETS2, &line) != 0) {
    return "these settings";
  }
  // Success means that something of it was taken. Adapters round rates; beyond 3 % nothing but garbage would arrive.
  termios2 taken{};
  if (::ioctl(descriptor, TCGETS2, &taken) != 0) {
    return "to tell its settings";
  }
  const double ratio = static_cast<double>(taken.c_ospeed) / settings.baud;
  if (ratio < 0.97 || ratio > 1.03) {
    return std::to_string(settings.baud) + " baud";
  }
  return setControlLines(descriptor, settings);
}

bool emptyLine(int descriptor) { return ::ioctl(descriptor, TCFLSH, TCIOFLUSH) == 0; }

} // namespace straightedge::devices
