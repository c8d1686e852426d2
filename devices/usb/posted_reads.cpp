#include "devices/usb/posted_reads.h"

#include <algorithm>
#include <ranges>
#include <sys/time.h>

namespace straightedge::devices {

std::optional<UsbFault> PostedReads::start(std::size_t size, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    Slot& slot = m_slots.emplace_back();
    slot.owner = this;
    slot.buffer.resize(size);
    slot.transfer.reset(libusb_alloc_transfer(0));
    if (!slot.transfer) {
      return UsbFault::Failed;
    }
    libusb_fill_bulk_transfer(slot.transfer.get(), m_handle, m_endpoint, slot.buffer.data(), static_cast<int>(size),
                              ended, &slot, 0);
    slot.transfer->type = m_type;
  }
  post();
  return m_broken;
}

void PostedReads::submit(Slot& slot) {
  const int code = libusb_submit_transfer(slot.transfer.get());
  slot.posted = code == LIBUSB_SUCCESS;
  if (code != LIBUSB_SUCCESS) {
    m_broken = usbFault(code);
  }
}

void PostedReads::submitAll() {
  for (Slot& slot : m_slots) {
    if (!slot.posted && !m_broken) {
      submit(slot);
    }
  }
}

void PostedReads::post() {
  m_broken.reset();
  submitAll();
}

bool PostedReads::anyPosted() const {
  return std::ranges::any_of(m_slots, [](const Slot& slot) { return slot.posted; });
}

void PostedReads::takeBack() {
  m_takingBack = true;
  for (Slot& slot : m_slots | std::views::reverse) { // the newest first: no other may slip in behind an older one
    if (slot.posted) {
      static_cast<void>(libusb_cancel_transfer(slot.transfer.get())); // NOT_FOUND: it has just ended by itself
    }
  }
  while (anyPosted()) {
    timeval wait{.tv_sec = 1, .tv_usec = 0};
    static_cast<void>(libusb_handle_events_timeout_completed(m_context, &wait, nullptr));
  }
  m_takingBack = false;
}

void PostedReads::ended(libusb_transfer* transfer) {
  Slot& slot = *static_cast<Slot*>(transfer->user_data);
  PostedReads& reads = *slot.owner;
  slot.posted = false;
  const auto size = static_cast<std::ptrdiff_t>(std::max(0, transfer->actual_length));
  if (size > 0 && transfer->status != LIBUSB_TRANSFER_OVERFLOW) { // of an overflow the length is not known
    reads.m_arrived.emplace_back(slot.buffer.begin(), slot.buffer.begin() + size);
  }
  if (transfer->status == LIBUSB_TRANSFER_COMPLETED) {
    if (!reads.m_takingBack && !reads.m_broken && reads.m_arrived.size() < mostArrived) {
      reads.submit(slot);
    }
  } else if (transfer->status != LIBUSB_TRANSFER_CANCELLED) {
    reads.m_broken = transferFault(transfer->status);
  }
}

std::vector<std::uint8_t> PostedReads::takeOldest() {
  auto oldest = std::move(m_arrived.front());
  m_arrived.pop_front();
  if (m_arrived.size() == mostArrived / 2) {
    submitAll();
  }
  return oldest;
}

} // namespace straightedge::devices
