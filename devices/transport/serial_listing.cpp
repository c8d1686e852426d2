#include "devices/transport/serial_port.h"

#include <algorithm>
#include <libserialport.h>
#include <unistd.h>

namespace straightedge::devices {

namespace {

std::string textOrEmpty(const char* text) { return text == nullptr ? std::string() : std::string(text); }

SerialPortInfo infoOf(const sp_port* port) {
  SerialPortInfo info{.path = textOrEmpty(sp_get_port_name(port)),
                      .description = textOrEmpty(sp_get_port_description(port)),
                      .vendorId = {},
                      .productId = {},
                      .usbSerial = textOrEmpty(sp_get_port_usb_serial(port)),
                      .usbProduct = textOrEmpty(sp_get_port_usb_product(port))};
  int vendor = 0;
  int product = 0;
  if (sp_get_port_usb_vid_pid(port, &vendor, &product) == SP_OK) {
    info.vendorId = static_cast<std::uint16_t>(vendor);
    info.productId = static_cast<std::uint16_t>(product);
  }
  return info;
}

} // namespace

Result<std::vector<SerialPortInfo>> listSerialPorts() {
  // A small container has no such folder: no tty then, and libserialport calls that a failure.
  if (::access("/sys/class/tty", F_OK) != 0) {
    return std::vector<SerialPortInfo>{};
  }
  sp_port** list = nullptr;
  if (const sp_return status = sp_list_ports(&list); status != SP_OK) {
    return fail(ErrorKind::Instrument, "the serial ports of this machine cannot be listed",
                "name the port by its path, for instance /dev/ttyUSB0", "serial ports");
  }
  std::vector<SerialPortInfo> ports;
  for (sp_port** port = list; *port != nullptr; ++port) {
    ports.push_back(infoOf(*port));
  }
  sp_free_port_list(list);
  std::ranges::sort(ports, {}, &SerialPortInfo::path);
  return ports;
}

} // namespace straightedge::devices
