// Everything that is plugged in, matched with the instruments that are known: what it is, what it can be used for, and
// what keeps it from opening.
#pragma once

#include "core/base/error.h"
#include "devices/instruments/instrument.h"
#include "devices/instruments/instrument_table.h"
#include "devices/instruments/profile_files.h"
#include "devices/transport/serial_port.h"
#include "devices/usb/usb_device.h"

#include <optional>
#include <string>
#include <vector>

namespace straightedge::devices {

/// A USB device, a serial port, or both where the kernel made a tty of the device.
struct ListedDevice {
  std::optional<UsbIds> ids; ///< none: a serial port that is not on USB
  std::string serial;        ///< of the USB device; may be empty
  std::string name;          ///< as the device calls itself, or as its ids or its port do
  std::string instrument;    ///< id in the instrument table or of a profile; empty: it cannot be told from outside
  std::string instrumentName;
  std::vector<std::string> candidates; ///< ids of what may be behind it, where it cannot be told
  std::vector<InstrumentRole> roles;   ///< that the instrument, or one of the candidates, can fill
  std::string problem;                 ///< why it cannot be opened; empty: nothing is known to be in the way
  std::string remedy;                  ///< what mends it
  std::optional<UsbDevice> usb;
  std::optional<SerialPortInfo> port;

  std::string label() const; ///< for messages: "Metrolab THM1176 (1bfa:0498 serial 0123)"
};

/// "1bfa"
std::string hexId(std::uint16_t id);

/// Pure: what is there, matched. A USB device that is a tty, too, is listed once. `mayOpen` says whether this user may
/// open the tty of that path.
std::vector<ListedDevice> matchDevices(const std::vector<UsbDevice>& usb, const std::vector<SerialPortInfo>& ports,
                                       const ProfileSet& profiles, bool (*mayOpen)(const std::string& path));

/// Looks anew each time. Nothing plugged in, or no USB on the machine, is an empty list and no error. Nothing is opened
/// for it. Thread: any. Errors (Instrument): the system does not let itself be asked.
Result<std::vector<ListedDevice>> listDevices(const ProfileSet& profiles);

} // namespace straightedge::devices
