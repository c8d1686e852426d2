#include "devices/usb/usb_handle_impl.h"

#include <algorithm>
#include <limits>
#include <sys/time.h>

namespace straightedge::devices {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds longestWait = std::chrono::hours(1); // bounds of what a timeval is asked to hold

timeval timevalOf(Clock::duration wait) {
  const auto us = std::max<std::int64_t>(0, std::chrono::duration_cast<std::chrono::microseconds>(wait).count());
  return {.tv_sec = us / 1'000'000, .tv_usec = us % 1'000'000};
}

/// Wakes the thread that waits for the transfer when the stop is requested.
struct Waker {
  libusb_context* context;
  void operator()() const { libusb_interrupt_event_handler(context); }
};

void onEnd(libusb_transfer* transfer) { *static_cast<int*>(transfer->user_data) = 1; }

} // namespace

UsbResult<std::size_t> UsbHandle::Impl::run(libusb_transfer* transfer, std::chrono::milliseconds deadline,
                                            std::string_view doing) {
  if (stop.stop_requested()) {
    return std::unexpected(usbError(UsbFault::Cancelled, doing, name));
  }
  int ended = 0;
  transfer->callback = onEnd;
  transfer->user_data = &ended;
  transfer->timeout = 0; // the deadline is kept here
  const int code = libusb_submit_transfer(transfer);
  if (code != LIBUSB_SUCCESS) {
    return usbFailure(code, doing, name);
  }
  const std::stop_callback wake(stop, Waker{context.get()});
  const auto end = Clock::now() + std::min(deadline, longestWait);
  bool takenBack = false;
  while (ended == 0) {
    const auto left = end - Clock::now();
    if (!takenBack && (left <= Clock::duration::zero() || stop.stop_requested())) {
      // Says NOT_FOUND when it has just ended by itself; either way its end is still to be handled.
      static_cast<void>(libusb_cancel_transfer(transfer));
      takenBack = true;
    }
    auto wait = timevalOf(takenBack ? Clock::duration(std::chrono::seconds(1)) : left);
    static_cast<void>(libusb_handle_events_timeout_completed(context.get(), &wait, &ended));
  }
  const auto bytes = static_cast<std::size_t>(std::max(0, transfer->actual_length));
  if (transfer->status == LIBUSB_TRANSFER_COMPLETED) {
    return bytes;
  }
  const bool stopped = transfer->status == LIBUSB_TRANSFER_CANCELLED && stop.stop_requested();
  auto failure = usbError(stopped ? UsbFault::Cancelled : transferFault(transfer->status), doing, name, bytes);
  return std::unexpected(std::move(failure));
}

UsbResult<std::size_t> UsbHandle::Impl::bulk(std::uint8_t endpoint, std::uint8_t* data, std::size_t size,
                                             std::chrono::milliseconds deadline, std::string_view doing) {
  if (size > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    return std::unexpected(usbError(UsbFault::Unsupported, doing, name));
  }
  const LibusbPtr<libusb_transfer> transfer(libusb_alloc_transfer(0));
  if (!transfer) {
    return usbFailure(LIBUSB_ERROR_NO_MEM, doing, name);
  }
  libusb_fill_bulk_transfer(transfer.get(), handle.get(), endpoint, data, static_cast<int>(size), nullptr, nullptr, 0);
  return run(transfer.get(), deadline, doing);
}

UsbResult<std::size_t> UsbHandle::bulkOut(std::uint8_t endpoint, std::span<const std::uint8_t> bytes,
                                          std::chrono::milliseconds deadline) {
  // libusb takes one kind of buffer for both directions and only reads this one.
  auto* data = const_cast<std::uint8_t*>(bytes.data());
  auto sent = m_impl->bulk(endpoint, data, bytes.size(), deadline, "sending");
  if (sent && *sent != bytes.size()) {
    return std::unexpected(usbError(UsbFault::Failed, "sending", name(), *sent));
  }
  return sent;
}

UsbResult<std::size_t> UsbHandle::bulkIn(std::uint8_t endpoint, std::span<std::uint8_t> buffer,
                                         std::chrono::milliseconds deadline) {
  return m_impl->bulk(endpoint, buffer.data(), buffer.size(), deadline, "receiving");
}

UsbResult<std::size_t> UsbHandle::control(const UsbSetup& setup, std::span<std::uint8_t> data,
                                          std::chrono::milliseconds deadline) {
  constexpr std::string_view doing = "control request";
  const bool in = (setup.requestType & LIBUSB_ENDPOINT_IN) != 0;
  std::vector<std::uint8_t> buffer(LIBUSB_CONTROL_SETUP_SIZE + data.size());
  libusb_fill_control_setup(buffer.data(), setup.requestType, setup.request, setup.value, setup.index,
                            static_cast<std::uint16_t>(data.size()));
  const auto payload = std::span(buffer).subspan(LIBUSB_CONTROL_SETUP_SIZE);
  if (!in) {
    std::ranges::copy(data, payload.begin());
  }
  const LibusbPtr<libusb_transfer> transfer(libusb_alloc_transfer(0));
  if (!transfer) {
    return usbFailure(LIBUSB_ERROR_NO_MEM, doing, name());
  }
  libusb_fill_control_transfer(transfer.get(), m_impl->handle.get(), buffer.data(), nullptr, nullptr, 0);
  const auto bytes = m_impl->run(transfer.get(), deadline, doing);
  if (bytes && in) {
    std::ranges::copy(payload.first(std::min(*bytes, payload.size())), data.begin());
  }
  return bytes;
}

PostedReads* UsbHandle::Impl::readsOf(std::uint8_t endpoint) const {
  const auto it = std::ranges::find_if(reads, [&](const auto& r) { return r->endpoint() == endpoint; });
  return it == reads.end() ? nullptr : it->get();
}

bool UsbHandle::Impl::isInterrupt(std::uint8_t endpoint) const {
  return std::ranges::any_of(interfaces, [&](const UsbInterface& interface) {
    const auto* found = interface.find(UsbEndpointType::Interrupt, true);
    return found != nullptr && found->address == endpoint;
  });
}

UsbResult<void> UsbHandle::startReading(std::uint8_t endpoint, std::size_t size, std::size_t count) {
  constexpr std::string_view doing = "listening";
  if (m_impl->readsOf(endpoint) != nullptr) {
    return std::unexpected(usbError(UsbFault::Unsupported, doing, name()));
  }
  const auto type = static_cast<unsigned char>(m_impl->isInterrupt(endpoint) ? LIBUSB_TRANSFER_TYPE_INTERRUPT
                                                                             : LIBUSB_TRANSFER_TYPE_BULK);
  auto reads = std::make_unique<PostedReads>(m_impl->context.get(), m_impl->handle.get(), endpoint, type);
  if (const auto fault = reads->start(size, count)) {
    return std::unexpected(usbError(*fault, doing, name()));
  }
  m_impl->reads.push_back(std::move(reads));
  return {};
}

UsbResult<std::vector<std::uint8_t>> UsbHandle::nextRead(std::uint8_t endpoint, std::chrono::milliseconds deadline) {
  constexpr std::string_view doing = "receiving";
  auto* reads = m_impl->readsOf(endpoint);
  if (reads == nullptr) {
    return std::unexpected(usbError(UsbFault::Unsupported, doing, name()));
  }
  const std::stop_callback wake(m_impl->stop, Waker{m_impl->context.get()});
  const auto end = Clock::now() + std::min(deadline, longestWait);
  for (bool looked = false;; looked = true) {
    if (reads->hasArrived()) { // what the system holds beside it comes when this is taken
      return reads->takeOldest();
    }
    if (m_impl->stop.stop_requested()) {
      return std::unexpected(usbError(UsbFault::Cancelled, doing, name()));
    }
    if (const auto fault = reads->broken()) {
      if (*fault != UsbFault::Gone) {
        reads->takeBack();
        static_cast<void>(libusb_clear_halt(m_impl->handle.get(), endpoint)); // posting tells whether it helped
        reads->post();
      }
      return std::unexpected(usbError(*fault, doing, name()));
    }
    const auto left = end - Clock::now();
    if (looked && left <= Clock::duration::zero()) {
      return std::unexpected(usbError(UsbFault::TimedOut, doing, name()));
    }
    // The first look does not wait: it only lets go on what has ended meanwhile.
    auto wait = timevalOf(looked ? left : Clock::duration::zero());
    static_cast<void>(libusb_handle_events_timeout_completed(m_impl->context.get(), &wait, nullptr));
  }
}

} // namespace straightedge::devices
