// Inside of UsbHandle: opening in usb_handle.cpp, transfers in usb_transfers.cpp.
#pragma once

#include "devices/usb/libusb_raii.h"
#include "devices/usb/usb_handle.h"

#include <deque>

namespace straightedge::devices {

/// The read that stays posted on an interrupt endpoint.
struct PostedInterrupt {
  LibusbPtr<libusb_transfer> transfer;
  std::vector<std::uint8_t> buffer; ///< one packet
  std::deque<std::vector<std::uint8_t>> arrived;
  std::uint8_t endpoint = 0;
  bool posted = false;
  bool closing = false;
  std::optional<UsbFault> broken; ///< why it is not posted any more
};

struct UsbHandle::Impl {
  std::string name;
  LibusbPtr<libusb_context> context; // before the handle: outlives it
  LibusbPtr<libusb_device_handle> handle;
  std::vector<std::uint8_t> claimed;
  std::stop_token stop;
  PostedInterrupt interrupt;

  /// Submits and waits in this thread; takes the transfer back when the deadline or the stop comes first.
  UsbResult<std::size_t> run(libusb_transfer* transfer, std::chrono::milliseconds deadline, std::string_view doing);
  UsbResult<std::size_t> bulk(std::uint8_t endpoint, std::uint8_t* data, std::size_t size,
                              std::chrono::milliseconds deadline, std::string_view doing);
  bool postInterrupt();
  void cancelInterrupt();
};

} // namespace straightedge::devices
