#include "app/gui/bench/device_watch.h"

#include "devices/usb/usb_hotplug.h"

#include <algorithm>
#include <chrono>

namespace straightedge::gui {

namespace {

constexpr std::chrono::milliseconds usualPeriod{2000};
// After an event: the kernel makes the tty, and udev sets its rights, a moment later.
constexpr std::chrono::milliseconds soonPeriod{200};
constexpr int looksSoon = 5;
// Events only: this thread looks by itself.
constexpr std::chrono::hours hotplugPeriod{24};

using Found = Result<std::vector<devices::ListedDevice>>;

bool looksTheSame(const devices::ListedDevice& a, const devices::ListedDevice& b) {
  const auto path = [](const devices::ListedDevice& device) { return device.port ? device.port->path : std::string(); };
  return a.ids == b.ids && a.serial == b.serial && a.name == b.name && a.instrument == b.instrument &&
         a.candidates == b.candidates && a.problem == b.problem && a.remedy == b.remedy && path(a) == path(b) &&
         a.usb == b.usb;
}

bool looksTheSame(const Found& a, const Found& b) {
  if (a.has_value() != b.has_value()) {
    return false;
  }
  return a ? std::ranges::equal(*a, *b, [](const auto& one, const auto& other) { return looksTheSame(one, other); })
           : a.error().message() == b.error().message();
}

} // namespace

DeviceWatch::DeviceWatch(devices::DeviceLister lister, bool byEvents, QObject* parent)
    : QObject(parent), m_lister(std::move(lister)), m_byEvents(byEvents),
      m_thread([this](const std::stop_token& stop) { run(stop); }) {}

DeviceWatch::~DeviceWatch() = default;

void DeviceWatch::setWatching(bool on) {
  const std::lock_guard lock(m_mutex);
  m_poked = m_poked || (on && !m_watching);
  m_watching = on;
  m_wake.notify_all();
}

void DeviceWatch::lookNow() {
  const std::lock_guard lock(m_mutex);
  m_poked = true;
  m_wake.notify_all();
}

void DeviceWatch::run(const std::stop_token& stop) {
  std::unique_ptr<devices::UsbHotplug> hotplug; // made here: asking for USB takes its time
  int soon = 0;
  std::unique_lock lock(m_mutex);
  while (!stop.stop_requested()) {
    if (!m_watching) {
      m_wake.wait(lock, stop, [this] { return m_watching; });
      continue;
    }
    soon = m_poked ? looksSoon : std::max(0, soon - 1);
    m_poked = false;
    lock.unlock();
    if (m_byEvents && !hotplug) {
      hotplug = std::make_unique<devices::UsbHotplug>([this](const devices::UsbHotplug::Change&) { lookNow(); },
                                                      hotplugPeriod);
    }
    look();
    lock.lock();
    m_wake.wait_for(lock, stop, soon > 0 ? soonPeriod : usualPeriod, [this] { return m_poked || !m_watching; });
  }
}

void DeviceWatch::look() {
  Found found = m_lister();
  if (m_last && looksTheSame(*m_last, found)) {
    return;
  }
  m_last = found;
  {
    const std::lock_guard lock(m_mutex);
    m_found = std::move(found);
  }
  QMetaObject::invokeMethod(this, &DeviceWatch::take, Qt::QueuedConnection);
}

void DeviceWatch::take() {
  std::optional<Found> found;
  {
    const std::lock_guard lock(m_mutex);
    found.swap(m_found);
  }
  if (!found) {
    return;
  }
  m_looked = true;
  m_problem = *found ? std::nullopt : std::optional(found->error());
  m_devices = *found ? std::move(**found) : std::vector<devices::ListedDevice>{};
  emit changed();
}

} // namespace straightedge::gui
