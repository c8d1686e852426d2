// Reads that stay posted on one endpoint: what arrives between two looks is kept by the kernel and then here.
#pragma once

#include "devices/usb/libusb_raii.h"

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace straightedge::devices {

/// Thread: the one that handles the context's events. The reads end in the order they were posted, each is posted again
/// at its end, so that the bytes stay in order. While `mostArrived` wait to be taken none is posted again: the device
/// then keeps its bytes, as far as it can, instead of filling memory, or holding on to a thread that is slower than it.
class PostedReads {
public:
  PostedReads(libusb_context* context, libusb_device_handle* handle, std::uint8_t endpoint, unsigned char type)
      : m_context(context), m_handle(handle), m_endpoint(endpoint), m_type(type) {}
  ~PostedReads() { takeBack(); }
  PostedReads(const PostedReads&) = delete;
  PostedReads& operator=(const PostedReads&) = delete;

  static constexpr std::size_t mostArrived = 256;

  std::uint8_t endpoint() const { return m_endpoint; }

  /// None if all `count` reads are posted.
  std::optional<UsbFault> start(std::size_t size, std::size_t count);

  void post();     ///< those that are not
  void takeBack(); ///< waits until none is under way; what had arrived stays

  bool hasArrived() const { return !m_arrived.empty(); }
  std::vector<std::uint8_t> takeOldest();
  std::optional<UsbFault> broken() const { return m_broken; } ///< why reads ended and were not posted again

private:
  struct Slot {
    PostedReads* owner = nullptr;
    LibusbPtr<libusb_transfer> transfer;
    std::vector<std::uint8_t> buffer;
    bool posted = false;
  };
  static void ended(libusb_transfer* transfer);
  void submit(Slot& slot);
  void submitAll(); ///< those that are not posted
  bool anyPosted() const;

  libusb_context* m_context;
  libusb_device_handle* m_handle;
  std::uint8_t m_endpoint;
  unsigned char m_type;
  std::deque<Slot> m_slots; // a deque: libusb holds their addresses
  std::deque<std::vector<std::uint8_t>> m_arrived;
  std::optional<UsbFault> m_broken;
  bool m_takingBack = false;
};

} // namespace straightedge::devices
