// libusb's objects as owners, and its codes as our errors. Only devices/usb includes this.
#pragma once

#include "devices/usb/usb_error.h"

#include <libusb.h>
#include <memory>
#include <string>
#include <string_view>

namespace straightedge::devices {

struct LibusbDeleter {
  void operator()(libusb_context* context) const { libusb_exit(context); }
  void operator()(libusb_device_handle* handle) const { libusb_close(handle); }
  void operator()(libusb_device* device) const { libusb_unref_device(device); }
  void operator()(libusb_config_descriptor* config) const { libusb_free_config_descriptor(config); }
  void operator()(libusb_transfer* transfer) const { libusb_free_transfer(transfer); }
};

template <typename T>
using LibusbPtr = std::unique_ptr<T, LibusbDeleter>;

/// A list with its references; the devices in it are gone with it.
class LibusbList {
public:
  LibusbList(libusb_device** devices, std::size_t count) : m_devices(devices), m_count(count) {}
  ~LibusbList() { libusb_free_device_list(m_devices, 1); }
  LibusbList(const LibusbList&) = delete;
  LibusbList& operator=(const LibusbList&) = delete;

  libusb_device* const* begin() const { return m_devices; }
  libusb_device* const* end() const { return m_devices + m_count; }

private:
  libusb_device** m_devices;
  std::size_t m_count;
};

/// The error of a code of libusb or of a transfer's end (transferFault()); `doing` as in "USB: <doing> failed".
UsbFault usbFault(int libusbCode);
UsbFault transferFault(libusb_transfer_status status);
UsbError usbError(UsbFault fault, std::string_view doing, std::string where, std::size_t bytes = 0);
std::unexpected<UsbError> usbFailure(int libusbCode, std::string_view doing, std::string where);

/// A context that has just looked at the bus.
UsbResult<LibusbPtr<libusb_context>> newLibusbContext();
UsbResult<std::unique_ptr<LibusbList>> libusbList(libusb_context* context);

} // namespace straightedge::devices
