#include "devices/usb/usb_hotplug.h"

#include "devices/usb/libusb_raii.h"

#include <algorithm>
#include <set>
#include <stop_token>
#include <thread>
#include <utility>

namespace straightedge::devices {

namespace {

/// The same device in the same place: its address changes with every plugging in.
bool isSameDevice(const UsbDevice& a, const UsbDevice& b) {
  return a.bus == b.bus && a.address == b.address && a.vendorId == b.vendorId && a.productId == b.productId &&
         a.port == b.port && a.serial == b.serial;
}

std::vector<UsbDevice> onlyIn(const std::vector<UsbDevice>& all, const std::vector<UsbDevice>& without) {
  std::vector<UsbDevice> rest;
  std::ranges::copy_if(all, std::back_inserter(rest), [&](const UsbDevice& device) {
    return std::ranges::none_of(without, [&](const UsbDevice& other) { return isSameDevice(device, other); });
  });
  return rest;
}

/// What libusb's callback noted since the last look.
struct Events {
  int any = 0;
  /// Left, but perhaps still listed: the kernel tells before it takes the device out of /sys.
  std::set<std::pair<std::uint8_t, std::uint8_t>> left; // bus, address
};

int onEvent(libusb_context* /*context*/, libusb_device* device, libusb_hotplug_event event, void* user) {
  auto& events = *static_cast<Events*>(user);
  const auto place = std::pair(libusb_get_bus_number(device), libusb_get_device_address(device));
  events.any = 1;
  if (event == LIBUSB_HOTPLUG_EVENT_DEVICE_LEFT) {
    events.left.insert(place);
  } else {
    events.left.erase(place);
  }
  return 0; // keep the callback
}

} // namespace

struct UsbHotplug::Impl {
  std::function<void(const Change&)> changed;
  std::chrono::milliseconds interval;
  LibusbPtr<libusb_context> context;
  std::vector<UsbDevice> known;
  Events events;
  std::jthread thread; // last: ends before what it uses

  void run(const std::stop_token& stop) {
    if (context) {
      // Without events (no udev) this registers all the same, and only the interval finds changes.
      static_cast<void>(libusb_hotplug_register_callback(
          context.get(), LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED | LIBUSB_HOTPLUG_EVENT_DEVICE_LEFT, 0,
          LIBUSB_HOTPLUG_MATCH_ANY, LIBUSB_HOTPLUG_MATCH_ANY, LIBUSB_HOTPLUG_MATCH_ANY, onEvent, &events, nullptr));
    }
    for (bool first = true; !stop.stop_requested(); first = false) {
      look(first);
      waitForEvent(stop);
    }
  }

  void look(bool first) {
    auto now = listUsbDevices();
    if (!now) {
      return; // the next look may succeed; nothing is said to have left on the strength of an error
    }
    std::set<std::pair<std::uint8_t, std::uint8_t>> stillListed;
    std::erase_if(*now, [&](const UsbDevice& device) {
      const auto place = std::pair(device.bus, device.address);
      if (!events.left.contains(place)) {
        return false;
      }
      stillListed.insert(place);
      return true;
    });
    events.left = std::move(stillListed);
    Change change{.arrived = onlyIn(*now, known), .left = onlyIn(known, *now)};
    known = std::move(*now);
    if (first || !change.arrived.empty() || !change.left.empty()) {
      changed(change);
    }
  }

  void waitForEvent(const std::stop_token& stop) {
    const auto end = std::chrono::steady_clock::now() + interval;
    while (events.any == 0 && !stop.stop_requested()) {
      const auto left = std::chrono::duration_cast<std::chrono::microseconds>(end - std::chrono::steady_clock::now());
      if (left.count() <= 0) {
        break;
      }
      timeval wait{.tv_sec = left.count() / 1'000'000, .tv_usec = left.count() % 1'000'000};
      if (!context || libusb_handle_events_timeout_completed(context.get(), &wait, &events.any) != LIBUSB_SUCCESS) {
        std::this_thread::sleep_for(std::min(left, std::chrono::microseconds(100'000)));
      }
    }
    events.any = 0;
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
