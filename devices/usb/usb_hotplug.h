// Tells when something is plugged in or leaves.
#pragma once

#include "devices/usb/usb_device.h"

#include <chrono>
#include <functional>
#include <memory>

namespace straightedge::devices {

/// Listens to the system's events and looks at the bus every `interval` beside them: where no udev runs (a container, a
/// minimal system) events never come. A vanished device is also told by its next transfer (UsbFault::Gone).
class UsbHotplug {
public:
  struct Change {
    std::vector<UsbDevice> arrived;
    std::vector<UsbDevice> left;
  };

  /// `changed` is called in a thread of this object's own, first with everything that is there already (perhaps
  /// nothing). It must not destroy this object.
  explicit UsbHotplug(std::function<void(const Change&)> changed,
                      std::chrono::milliseconds interval = std::chrono::seconds(2));
  ~UsbHotplug(); ///< no call comes after it
  UsbHotplug(const UsbHotplug&) = delete;
  UsbHotplug& operator=(const UsbHotplug&) = delete;

private:
  struct Impl;
  std::unique_ptr<Impl> m_impl;
};

} // namespace straightedge::devices
