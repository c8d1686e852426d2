#include "devices/usb/libusb_raii.h"

#include "devices/usb/access_remedy.h"

namespace straightedge::devices {

namespace {

struct FaultText {
  std::string_view what;
  std::string_view remedy;
};

FaultText textOf(UsbFault fault) {
  switch (fault) {
  case UsbFault::AccessDenied:
    return {"access to the USB device is denied", accessRemedy()};
  case UsbFault::Busy:
    return {"another program has the USB device open", "close the program that uses it, then try again"};
  case UsbFault::Gone:
    return {"the USB device is gone", "plug it in and switch it on"};
  case UsbFault::TimedOut:
    return {"the USB device did not answer in time",
            "check that it is switched on and not busy, or allow it more time"};
  case UsbFault::Stalled:
    return {"the USB device refused the transfer", "check that it knows the command"};
  case UsbFault::Overflow:
    return {"the USB device sent more than it was asked for",
            "repeat the query; if it stays, switch the device off and on"};
  case UsbFault::Unsupported:
    return {"the USB device or the system cannot do this", "check that it is the device you mean"};
  case UsbFault::Cancelled:
    return {"stopped", ""};
  case UsbFault::Failed:
    break;
  }
  return {"the USB transfer failed", "check the cable, then unplug the device and plug it in again"};
}

} // namespace

UsbFault usbFault(int libusbCode) {
  switch (libusbCode) {
  case LIBUSB_ERROR_ACCESS:
    return UsbFault::AccessDenied;
  case LIBUSB_ERROR_BUSY:
    return UsbFault::Busy;
  case LIBUSB_ERROR_NO_DEVICE:
  case LIBUSB_ERROR_NOT_FOUND:
    return UsbFault::Gone;
  case LIBUSB_ERROR_TIMEOUT:
    return UsbFault::TimedOut;
  case LIBUSB_ERROR_PIPE:
    return UsbFault::Stalled;
  case LIBUSB_ERROR_OVERFLOW:
    return UsbFault::Overflow;
  case LIBUSB_ERROR_NOT_SUPPORTED:
    return UsbFault::Unsupported;
  default:
    return UsbFault::Failed;
  }
}

UsbFault transferFault(libusb_transfer_status status) {
  switch (status) {
  case LIBUSB_TRANSFER_TIMED_OUT:
  case LIBUSB_TRANSFER_CANCELLED:
    return UsbFault::TimedOut;
  case LIBUSB_TRANSFER_STALL:
    return UsbFault::Stalled;
  case LIBUSB_TRANSFER_NO_DEVICE:
    return UsbFault::Gone;
  case LIBUSB_TRANSFER_OVERFLOW:
    return UsbFault::Overflow;
  case LIBUSB_TRANSFER_COMPLETED:
  case LIBUSB_TRANSFER_ERROR:
    break;
  }
  return UsbFault::Failed;
}

UsbError usbError(UsbFault fault, std::string_view doing, std::string where, std::size_t bytes) {
  const auto text = textOf(fault);
  std::string what(doing);
  what += ": ";
  what += text.what;
  return {fault,
          Error{fault == UsbFault::Cancelled ? ErrorKind::Cancelled : ErrorKind::Instrument, std::move(what),
                std::string(text.remedy), std::move(where)},
          bytes};
}

std::unexpected<UsbError> usbFailure(int libusbCode, std::string_view doing, std::string where) {
  auto failure = usbError(usbFault(libusbCode), doing, std::move(where));
  if (failure.fault == UsbFault::Failed) {
    failure.error.what += std::string(" (") + libusb_error_name(libusbCode) + ")";
  }
  return std::unexpected(std::move(failure));
}

UsbResult<LibusbPtr<libusb_context>> newLibusbContext() {
  libusb_context* context = nullptr;
  const int code = libusb_init(&context);
  if (code != LIBUSB_SUCCESS) {
    return usbFailure(code, "starting USB", "USB");
  }
  return LibusbPtr<libusb_context>(context);
}

UsbResult<std::unique_ptr<LibusbList>> libusbList(libusb_context* context) {
  libusb_device** devices = nullptr;
  const auto count = libusb_get_device_list(context, &devices);
  if (count < 0) {
    return usbFailure(static_cast<int>(count), "listing USB devices", "USB");
  }
  return std::make_unique<LibusbList>(devices, static_cast<std::size_t>(count));
}

} // namespace straightedge::devices
