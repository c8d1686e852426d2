#include "devices/usb/usb_device.h"

#include "devices/usb/libusb_raii.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <unistd.h>

namespace straightedge::devices {

namespace {

std::string hex4(std::uint16_t value) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  for (const unsigned shift : {12U, 8U, 4U, 0U}) {
    text += digits[(unsigned{value} >> shift) & 0xFU];
  }
  return text;
}

std::string threeDigits(unsigned value) {
  std::string text = std::to_string(value);
  return std::string(3 - std::min<std::size_t>(3, text.size()), '0') + text;
}

std::string portOf(libusb_device* device) {
  std::array<std::uint8_t, 8> ports{};
  const int count = libusb_get_port_numbers(device, ports.data(), static_cast<int>(ports.size()));
  std::string text = std::to_string(libusb_get_bus_number(device));
  for (int i = 0; i < count; ++i) {
    text += i == 0 ? '-' : '.';
    text += std::to_string(ports.at(static_cast<std::size_t>(i)));
  }
  return text;
}

const std::string sysfsFolder = "/sys/bus/usb/devices/";

/// The kernel read the strings when the device was plugged in: no need to open it, nor the right to.
std::string attribute(const std::string& port, const std::string& attributeName) {
  std::ifstream file(sysfsFolder + port + "/" + attributeName, std::ios::binary);
  std::string line;
  std::getline(file, line);
  return line;
}

std::string driverOf(const std::string& port, unsigned configuration, unsigned interfaceNumber) {
  const std::string link =
      sysfsFolder + port + ":" + std::to_string(configuration) + "." + std::to_string(interfaceNumber) + "/driver";
  std::array<char, 512> target{};
  const auto length = ::readlink(link.c_str(), target.data(), target.size());
  if (length <= 0) {
    return {};
  }
  const std::string_view path(target.data(), static_cast<std::size_t>(length));
  return std::string(path.substr(path.rfind('/') + 1));
}

UsbEndpointType endpointType(std::uint8_t attributes) {
  return static_cast<UsbEndpointType>(attributes & LIBUSB_TRANSFER_TYPE_MASK);
}

std::vector<UsbInterface> interfacesOf(libusb_device* device, const std::string& port) {
  libusb_config_descriptor* raw = nullptr;
  if (libusb_get_active_config_descriptor(device, &raw) != LIBUSB_SUCCESS &&
      libusb_get_config_descriptor(device, 0, &raw) != LIBUSB_SUCCESS) {
    return {};
  }
  const LibusbPtr<libusb_config_descriptor> config(raw);
  std::vector<UsbInterface> interfaces;
  for (int i = 0; i < config->bNumInterfaces; ++i) {
    const libusb_interface& all = config->interface[i];
    for (int alternate = 0; alternate < all.num_altsetting; ++alternate) {
      const libusb_interface_descriptor& from = all.altsetting[alternate];
      UsbInterface to{.number = from.bInterfaceNumber,
                      .alternate = from.bAlternateSetting,
                      .classCode = from.bInterfaceClass,
                      .subclass = from.bInterfaceSubClass,
                      .protocol = from.bInterfaceProtocol,
                      .driver = driverOf(port, config->bConfigurationValue, from.bInterfaceNumber),
                      .endpoints = {}};
      for (int e = 0; e < from.bNumEndpoints; ++e) {
        const libusb_endpoint_descriptor& endpoint = from.endpoint[e];
        to.endpoints.push_back({.address = endpoint.bEndpointAddress,
                                .type = endpointType(endpoint.bmAttributes),
                                .packetSize = static_cast<std::uint16_t>(endpoint.wMaxPacketSize & 0x7FFU)});
      }
      interfaces.push_back(std::move(to));
    }
  }
  return interfaces;
}

void explainAccess(UsbDevice& device) {
  const std::string node = "/dev/bus/usb/" + threeDigits(device.bus) + "/" + threeDigits(device.address);
  if (::access(node.c_str(), R_OK | W_OK) == 0) {
    const bool held = std::ranges::any_of(device.interfaces, [](const auto& i) { return i.driver == "usbfs"; });
    if (held) {
      const auto busy = usbError(UsbFault::Busy, node, {});
      device.problem = busy.error.what;
      device.remedy = busy.error.remedy;
    }
    return;
  }
  if (errno == EACCES || errno == EPERM) {
    const auto denied = usbError(UsbFault::AccessDenied, node, {});
    device.problem = denied.error.what;
    device.remedy = denied.error.remedy;
    return;
  }
  device.problem = node + ": there is no device node";
  device.remedy = "give this container or sandbox access to /dev/bus/usb";
}

} // namespace

const UsbEndpoint* UsbInterface::find(UsbEndpointType type, bool in) const {
  const auto it =
      std::ranges::find_if(endpoints, [&](const UsbEndpoint& e) { return e.type == type && e.isIn() == in; });
  return it == endpoints.end() ? nullptr : &*it;
}

std::string UsbDevice::label() const {
  std::string text = hex4(vendorId) + ":" + hex4(productId);
  text += serial.empty() ? " at " + port : " serial " + serial;
  return text;
}

const UsbInterface* UsbDevice::findInterface(std::uint8_t classCode, std::uint8_t subclass) const {
  const auto it = std::ranges::find_if(
      interfaces, [&](const UsbInterface& i) { return i.classCode == classCode && i.subclass == subclass; });
  return it == interfaces.end() ? nullptr : &*it;
}

UsbResult<std::vector<UsbDevice>> listUsbDevices() {
  // A new context scans the bus; an old one learns of changes by udev's events only, which not every system has.
  const auto context = newLibusbContext();
  if (!context) {
    return std::unexpected(context.error());
  }
  const auto list = libusbList(context->get());
  if (!list) {
    return std::unexpected(list.error());
  }
  std::vector<UsbDevice> devices;
  for (libusb_device* device : **list) {
    libusb_device_descriptor descriptor{};
    if (libusb_get_device_descriptor(device, &descriptor) != LIBUSB_SUCCESS ||
        descriptor.bDeviceClass == LIBUSB_CLASS_HUB) {
      continue;
    }
    UsbDevice found{.vendorId = descriptor.idVendor,
                    .productId = descriptor.idProduct,
                    .release = descriptor.bcdDevice,
                    .deviceClass = descriptor.bDeviceClass,
                    .manufacturer = {},
                    .product = {},
                    .serial = {},
                    .bus = libusb_get_bus_number(device),
                    .address = libusb_get_device_address(device),
                    .port = portOf(device),
                    .interfaces = {},
                    .problem = {},
                    .remedy = {}};
    found.manufacturer = attribute(found.port, "manufacturer");
    found.product = attribute(found.port, "product");
    found.serial = attribute(found.port, "serial");
    found.interfaces = interfacesOf(device, found.port);
    explainAccess(found);
    devices.push_back(std::move(found));
  }
  std::ranges::sort(devices, {}, [](const UsbDevice& d) { return std::pair(d.bus, d.address); });
  return devices;
}

} // namespace straightedge::devices
