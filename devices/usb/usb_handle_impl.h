// Inside of UsbHandle: opening in usb_handle.cpp, transfers in usb_transfers.cpp and posted_reads.cpp.
#pragma once

#include "devices/usb/libusb_raii.h"
#include "devices/usb/posted_reads.h"
#include "devices/usb/usb_handle.h"

#include <memory>

namespace straightedge::devices {

struct UsbHandle::Impl {
  std::string name;
  LibusbPtr<libusb_context> context; // before the handle: outlives it
  LibusbPtr<libusb_device_handle> handle;
  std::vector<std::uint8_t> claimed;
  std::vector<UsbInterface> interfaces; ///< of the snapshot
  std::stop_token stop;
  std::vector<std::unique_ptr<PostedReads>> reads; // one per endpoint; before the handle is closed they are taken back

  /// Submits and waits in this thread; takes the transfer back when the deadline or the stop comes first.
  UsbResult<std::size_t> run(libusb_transfer* transfer, std::chrono::milliseconds deadline, std::string_view doing);
  UsbResult<std::size_t> bulk(std::uint8_t endpoint, std::uint8_t* data, std::size_t size,
                              std::chrono::milliseconds deadline, std::string_view doing);
  PostedReads* readsOf(std::uint8_t endpoint) const;
  bool isInterrupt(std::uint8_t endpoint) const; ///< by the descriptor
};

} // namespace straightedge::devices
