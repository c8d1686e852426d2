#include "devices/usb/usb_hotplug.h"

#include "devices/usb/libusb_raii.h"

#include <algorithm>
#include <atomic>
#include <stop_token>
#include <thread>

namespace straightedge::devices {

namespace {

/// The same device in the same place: its address changes with every plugging in.
bool isSame(const UsbDevice& a, const UsbDevice& b) {
  return a.bus == b.bus && a.address == b.address && a.vendorId == b.vendorId && a.productId == b.productId &&
         a.port == b.port && a.serial == b.serial;
}

std::vector<UsbDevice> onlyIn(const std::vector<UsbDevice>& all, const std::vector<UsbDevice>& without) {
  std::vector<UsbDevice> rest;
  std::ranges::copy_if(all, std::back_inserter(rest), [&](const UsbDevice& device) {
    return std::ranges::none_of(without, [&](const UsbDevice& other) { return isSame(device, other); });
  });
  return rest;
}

int onEvent(libusb_context* /*context*/, libusb_device* /*device*/, libusb_hotplug_event /*event*/, void* seen) {
  *static_cast<int*>(seen) = 1;
  return 0; // keep the callback
}

} // namespace

struct UsbHotplug::Impl {
  std::function<void(const Change&)> changed;
  std::chrono::milliseconds interval;
  LibusbPtr<libusb_context> context;
  std::vector<UsbDevice> known;
  std::jthread thread; // last: ends before what it uses

  void run(const std::stop_token& stop) {
    bool first = true;
    int event = 0;
    if (context) {
      // Without events (no udev) this registers all the same, and only the interval finds changes.
      static_cast<void>(libusb_hotplug_register_callback(
          context.get(), LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED | LIBUSB_HOTPLUG_EVENT_DEVICE_LEFT, 0,
          LIBUSB_HOTPLUG_MATCH_ANY, LIBUSB_HOTPLUG_MATCH_ANY, LIBUSB_HOTPLUG_MATCH_ANY, onEvent, &event, nullptr));
    }
    while (!stop.stop_requested()) {
      look(first);
      first = false;
      waitForEvent(stop, event);
    }
  }

  void look(bool first) {
    auto now = listUsbDevices();
    if (!now) {
      return; // the next look may succeed; nothing is said to have left on the strength of an error
    }
    Change change{.arrived = onlyIn(*now, known), .left = onlyIn(known, *now)};
    known = std::move(*now);
    if (first || !change.arrived.empty() || !change.left.empty()) {
      changed(change);
    }
  }

  void waitForEvent(const std::stop_token& stop, int& event) const {
    const auto end = std::chrono::steady_clock::now() + interval;
    while (event == 0 && !stop.stop_requested()) {
      const auto left = std::chrono::duration_cast<std::chrono::microseconds>(end - std::chrono::steady_clock::now());
      if (left.count() <= 0) {
        return;
      }
      timeval wait{.tv_sec = left.count() / 1'000'000, .tv_usec = left.count() % 1'000'000};
      if (!context || libusb_handle_events_timeout_completed(context.get(), &wait, &event) != LIBUSB_SUCCESS) {
        std::this_thread::sleep_for(std::min(left, std::chrono::microseconds(100'000)));
      }
    }
    event = 0;
  }
};

UsbHotplug::UsbHotplug(std::function<void(const Change&)> changed, std::chrono::milliseconds interval)
    : m_impl(std::make_unique<Impl>()) {
  m_impl->changed = std::move(changed);
  m_impl->interval = interval;
  if (auto context = newLibusbContext()) {
    m_impl->context = std::move(*context);
  }
  m_impl->thread = std::jthread([impl = m_impl.get()](const std::stop_token& stop) { impl->run(stop); });
}

UsbHotplug::~UsbHotplug() {
  m_impl->thread.request_stop();
  if (m_impl->context) {
    libusb_interrupt_event_handler(m_impl->context.get());
  }
}

} // namespace straightedge::devices
