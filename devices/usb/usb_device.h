// What is plugged in, as plain data: a snapshot of descriptors that outlives the device.
#pragma once

#include "devices/usb/usb_error.h"

#include <cstdint>
#include <string>
#include <vector>

namespace straightedge::devices {

enum class UsbEndpointType : std::uint8_t { Control, Isochronous, Bulk, Interrupt };

struct UsbEndpoint {
  std::uint8_t address = 0; ///< bit 7: into the computer
  UsbEndpointType type = UsbEndpointType::Bulk;
  std::uint16_t packetSize = 0; ///< wMaxPacketSize

  bool isIn() const { return (address & 0x80U) != 0; }
  friend bool operator==(const UsbEndpoint&, const UsbEndpoint&) = default;
};

struct UsbInterface {
  std::uint8_t number = 0;
  std::uint8_t alternate = 0;
  std::uint8_t classCode = 0;
  std::uint8_t subclass = 0;
  std::uint8_t protocol = 0;
  std::string driver = {}; ///< the kernel's driver; "usbfs" while a program holds it; empty when free
  std::vector<UsbEndpoint> endpoints = {};
  friend bool operator==(const UsbInterface&, const UsbInterface&) = default;

  /// The first one of this type and direction, or null.
  const UsbEndpoint* find(UsbEndpointType type, bool in) const;
};

struct UsbDevice {
  std::uint16_t vendorId = 0;
  std::uint16_t productId = 0;
  std::uint16_t release = 0; ///< bcdDevice
  std::uint8_t deviceClass = 0;
  std::string manufacturer = {}; ///< strings of the device; empty where it has none or they cannot be read
  std::string product = {};
  std::string serial = {};
  std::uint8_t bus = 0;
  std::uint8_t address = 0; ///< changes every time the device is plugged in
  std::string port = {};    ///< "1-4.2": bus and ports, the same whenever it is plugged in there
  std::vector<UsbInterface> interfaces = {};
  std::string problem = {}; ///< why it cannot be opened, empty if nothing is known to be in the way
  std::string remedy = {};  ///< what mends it
  friend bool operator==(const UsbDevice&, const UsbDevice&) = default;

  std::string label() const; ///< "1bfa:0498 serial 0123", or "1bfa:0498 at 1-4.2" without one
  std::string name() const { return "USB " + label(); } ///< for messages

  const UsbInterface* findInterface(std::uint8_t classCode, std::uint8_t subclass) const;
};

/// Looks at the bus anew each time, so that it is right without udev events too. Hubs are left out. Without any USB on
/// the machine the list is empty: that cannot be told from nothing being plugged in. Devices are not opened for it.
/// Thread: any.
UsbResult<std::vector<UsbDevice>> listUsbDevices();

} // namespace straightedge::devices
