#include "devices/usb/usb_handle.h"

#include "devices/usb/usb_handle_impl.h"

namespace straightedge::devices {

namespace {

UsbResult<LibusbPtr<libusb_device_handle>> openHandle(libusb_context* context, const UsbDevice& device) {
  const auto list = libusbList(context);
  if (!list) {
    return std::unexpected(list.error());
  }
  for (libusb_device* candidate : **list) {
    libusb_device_descriptor descriptor{};
    // The address is given anew at every plugging in, so that it and the product tell whether it is still the same one.
    if (libusb_get_bus_number(candidate) != device.bus || libusb_get_device_address(candidate) != device.address ||
        libusb_get_device_descriptor(candidate, &descriptor) != LIBUSB_SUCCESS ||
        descriptor.idVendor != device.vendorId || descriptor.idProduct != device.productId) {
      continue;
    }
    libusb_device_handle* handle = nullptr;
    const int code = libusb_open(candidate, &handle);
    if (code != LIBUSB_SUCCESS) {
      return usbFailure(code, "opening", device.name());
    }
    return LibusbPtr<libusb_device_handle>(handle);
  }
  return std::unexpected(usbError(UsbFault::Gone, "opening", device.name()));
}

} // namespace

UsbHandle::UsbHandle(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}

UsbHandle::~UsbHandle() {
  m_impl->reads.clear();
  for (const std::uint8_t number : m_impl->claimed) {
    // A device that is gone cannot be released, and nobody misses it.
    static_cast<void>(libusb_release_interface(m_impl->handle.get(), number));
  }
}

UsbResult<std::unique_ptr<UsbHandle>> UsbHandle::open(const UsbDevice& device, std::vector<std::uint8_t> interfaces) {
  auto context = newLibusbContext();
  if (!context) {
    return std::unexpected(context.error());
  }
  auto impl = std::make_unique<Impl>();
  impl->name = device.name();
  impl->interfaces = device.interfaces;
  impl->context = std::move(*context);
  auto handle = openHandle(impl->context.get(), device);
  if (!handle) {
    return std::unexpected(handle.error());
  }
  impl->handle = std::move(*handle);
  // Unsupported where the system has no kernel drivers to detach; claiming says so if it matters.
  static_cast<void>(libusb_set_auto_detach_kernel_driver(impl->handle.get(), 1));
  std::unique_ptr<UsbHandle> opened(new UsbHandle(std::move(impl)));
  for (const std::uint8_t number : interfaces) {
    const int code = libusb_claim_interface(opened->m_impl->handle.get(), number);
    if (code != LIBUSB_SUCCESS) {
      return usbFailure(code, "claiming interface " + std::to_string(number), opened->name());
    }
    opened->m_impl->claimed.push_back(number);
  }
  return opened;
}

void UsbHandle::setStop(std::stop_token stop) { m_impl->stop = std::move(stop); }

std::string UsbHandle::name() const { return m_impl->name; }

UsbResult<void> UsbHandle::clearHalt(std::uint8_t endpoint) {
  const int code = libusb_clear_halt(m_impl->handle.get(), endpoint);
  if (code != LIBUSB_SUCCESS) {
    return usbFailure(code, "clearing a halted endpoint", name());
  }
  return {};
}

UsbResult<void> UsbHandle::reset() {
  for (const auto& reads : m_impl->reads) {
    reads->takeBack(); // libusb wants no transfer under way
  }
  const int code = libusb_reset_device(m_impl->handle.get());
  if (code != LIBUSB_SUCCESS) {
    return usbFailure(code, "resetting", name());
  }
  for (const auto& reads : m_impl->reads) {
    reads->post();
  }
  return {};
}

} // namespace straightedge::devices
