#include "tests/fakes/usb/emulated_usb.h"

#include "tests/fakes/usb/host_controller.h"

#include <array>
#include <stdexcept>
#include <sys/stat.h>

namespace straightedge::fakes {

namespace {

const std::string hostPath = "/devices/pci0000:00/0000:00:14.0/usb1";

std::string digits(unsigned value, std::size_t width) {
  const std::string text = std::to_string(value);
  return std::string(width - std::min(width, text.size()), '0') + text;
}

std::string hex(const Bytes& bytes) {
  constexpr std::string_view figures = "0123456789ABCDEF";
  std::string text;
  for (const unsigned byte : bytes) {
    text += figures[byte >> 4U];
    text += figures[byte & 0xFU];
  }
  return text;
}

Bytes deviceDescriptor(const EmulatedDevice& device) {
  const auto& id = device.identity();
  const auto low = [](unsigned v) { return static_cast<std::uint8_t>(v & 0xFFU); };
  const auto high = [](unsigned v) { return static_cast<std::uint8_t>(v >> 8U); };
  return {18,
          1,
          0x00,
          0x02,
          0,
          0,
          0,
          64,
          low(id.vendorId),
          high(id.vendorId),
          low(id.productId),
          high(id.productId),
          low(id.release),
          high(id.release),
          1,
          2,
          static_cast<std::uint8_t>(id.serial.empty() ? 0 : 3),
          1};
}

void attributeLine(std::string& record, std::string_view name, std::string_view value) {
  if (!value.empty()) {
    record += "A: " + std::string(name) + "=" + std::string(value) + "\\n\n";
  }
}

struct Plugged {
  std::unique_ptr<HostController> controller;
  GPtr<UMockdevIoctlBase> handler;
  std::string node;    ///< "/dev/bus/usb/001/002"
  std::string sysPath; ///< "/sys/devices/…/1-1"
  bool events = true;
  bool listed = true; ///< in the emulated sysfs
};

gboolean onIoctl(UMockdevIoctlBase* /*handler*/, UMockdevIoctlClient* client, Plugged* plugged) {
  const auto held = plugged->controller->device().lock();
  return plugged->controller->handle(client) ? TRUE : FALSE;
}

} // namespace

struct EmulatedUsb::Impl {
  std::string root;
  GPtr<UMockdevTestbed> testbed{umockdev_testbed_new()};
  std::vector<std::unique_ptr<Plugged>> all; // kept after unplugging: programs may still hold the node open
  std::set<std::string> hubs;
  unsigned nextAddress = 2;   // 1 is the root hub's
  std::recursive_mutex mutex; // never taken before a device's own lock is wanted

  Plugged& at(Plug plug) {
    const std::scoped_lock lock(mutex);
    return *all.at(static_cast<std::size_t>(plug));
  }

  /// Without the hub in front of it libusb cannot tell a device's ports.
  void addHubBefore(const std::string& port) {
    const auto dot = port.rfind('.');
    if (dot == std::string::npos || !hubs.insert(port.substr(0, dot)).second) {
      return;
    }
    addHubBefore(port.substr(0, dot));
    const unsigned address = nextAddress++;
    std::string record = "P: " + hostPath + "/1-" + port.substr(0, dot) + "\nN: bus/usb/001/" + digits(address, 3) +
                         "\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\nE: DEVNAME=/dev/bus/usb/001/" +
                         digits(address, 3) + "\n";
    attributeLine(record, "busnum", "1");
    attributeLine(record, "devnum", std::to_string(address));
    attributeLine(record, "bConfigurationValue", "1");
    attributeLine(record, "speed", "480");
    Bytes descriptors = {18, 1, 0, 2, 9, 0, 1, 64, 0x6B, 0x1D, 2, 0, 0, 1, 0, 0, 0, 1};
    Bytes interface = interfaceDescriptor(0, 1, 9, 0, 0);
    append(interface, endpointDescriptor(0x81, 3, 1));
    append(descriptors, configurationHeader(1, interface));
    record += "H: descriptors=" + hex(descriptors) + "\n";
    umockdev_testbed_add_from_string(testbed.get(), record.c_str(), nullptr);
  }

  void takeFromSysfs(Plugged& plugged) {
    const std::scoped_lock lock(mutex);
    if (!plugged.listed) {
      return;
    }
    plugged.listed = false;
    if (plugged.events) { // as the kernel does: first the event, then the folder goes
      umockdev_testbed_uevent(testbed.get(), plugged.sysPath.c_str(), "remove");
    }
    umockdev_testbed_remove_device(testbed.get(), plugged.sysPath.c_str());
  }
};

EmulatedUsb::EmulatedUsb() : m_impl(std::make_unique<Impl>()) {
  if (umockdev_in_mock_environment() == FALSE) {
    throw std::runtime_error("run this test with LD_PRELOAD=libumockdev-preload.so.0 (ctest does)");
  }
  char* root = umockdev_testbed_get_root_dir(m_impl->testbed.get());
  m_impl->root = root;
  g_free(root);
}

EmulatedUsb::~EmulatedUsb() {
  for (const auto& plugged : m_impl->all) {
    const auto held = plugged->controller->device().lock();
    plugged->controller->deviceGone();
  }
}

EmulatedUsb::Plug EmulatedUsb::plug(std::shared_ptr<EmulatedDevice> device, const PlugOptions& options) {
  const std::scoped_lock lock(m_impl->mutex);
  const auto index = static_cast<Plug>(m_impl->all.size());
  const std::string port = options.port.empty() ? std::to_string(index + 1) : options.port;
  const auto configuration = device->configurationDescriptor();
  {
    const auto held = device->lock();
    device->m_leaving = false;
    device->m_in.clear();
    device->m_halted.clear();
  }

  m_impl->addHubBefore(port);
  auto plugged = std::make_unique<Plugged>();
  Plugged* at = plugged.get();
  const unsigned address = m_impl->nextAddress++;
  plugged->node = "/dev/bus/usb/001/" + digits(address, 3);
  plugged->sysPath = "/sys" + hostPath + "/1-" + port;
  plugged->events = options.events;
  plugged->controller = std::make_unique<HostController>(device, options.driver, [this, at] {
    at->controller->deviceGone();
    m_impl->takeFromSysfs(*at);
  });
  plugged->controller->setHeldByOther(options.heldByAnotherProgram);
  plugged->handler.reset(umockdev_ioctl_base_new());
  g_signal_connect(plugged->handler.get(), "handle-ioctl", G_CALLBACK(onIoctl), at);
  m_impl->all.push_back(std::move(plugged));

  // The ioctls before the device: libusb's own thread may open it as soon as it is told of it.
  auto* testbed = m_impl->testbed.get();
  if (umockdev_testbed_attach_ioctl(testbed, at->node.c_str(), at->handler.get(), nullptr) == FALSE) {
    throw std::runtime_error("umockdev does not attach to " + at->node);
  }
  auto descriptors = deviceDescriptor(*device);
  append(descriptors, configuration);
  std::string record = "P: " + hostPath + "/1-" + port + "\nN: " + at->node.substr(5) +
                       "\nE: SUBSYSTEM=usb\nE: DRIVER=usb\nE: BUSNUM=001\nE: DEVNUM=" + digits(address, 3) +
                       "\nE: DEVNAME=" + at->node + "\n";
  if (options.events) { // the monitors take no notice of a device without its type
    record += "E: DEVTYPE=usb_device\n";
  }
  attributeLine(record, "busnum", "1");
  attributeLine(record, "devnum", std::to_string(address));
  attributeLine(record, "bConfigurationValue", "1");
  attributeLine(record, "speed", device->highSpeed() ? "480" : "12");
  attributeLine(record, "manufacturer", device->identity().manufacturer);
  attributeLine(record, "product", device->identity().product);
  attributeLine(record, "serial", device->identity().serial);
  record += "H: descriptors=" + hex(descriptors) + "\n";

  const std::string driver = options.heldByAnotherProgram ? "usbfs" : options.driver;
  if (!driver.empty()) {
    for (unsigned i = 0; i < configuration[4]; ++i) {
      record += "\nP: " + hostPath + "/1-" + port + "/1-" + port + ":1." + std::to_string(i) +
                "\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_interface\nL: driver=../../../../../../bus/usb/drivers/" + driver +
                "\n";
    }
  }
  GError* error = nullptr;
  if (umockdev_testbed_add_from_string(testbed, record.c_str(), &error) == FALSE) {
    throw std::runtime_error(std::string("umockdev does not add the device: ") + error->message);
  }
  if (!options.events) {
    umockdev_testbed_set_property(testbed, at->sysPath.c_str(), "DEVTYPE", "usb_device");
  }
  return index;
}

void EmulatedUsb::unplug(Plug plug) {
  Plugged& plugged = m_impl->at(plug);
  {
    const auto held = plugged.controller->device().lock();
    plugged.controller->deviceGone();
  }
  m_impl->takeFromSysfs(plugged);
}

void EmulatedUsb::tellLeaving(Plug plug) {
  umockdev_testbed_uevent(m_impl->testbed.get(), m_impl->at(plug).sysPath.c_str(), "remove");
}

bool EmulatedUsb::isPlugged(Plug plug) const {
  const Plugged& plugged = m_impl->at(plug);
  const auto held = plugged.controller->device().lock();
  return !plugged.controller->isGone();
}

void EmulatedUsb::letGo(Plug plug) {
  Plugged& plugged = m_impl->at(plug);
  const auto held = plugged.controller->device().lock();
  plugged.controller->setHeldByOther(false);
}

std::string EmulatedUsb::driver(Plug plug, int interfaceNumber) const {
  const Plugged& plugged = m_impl->at(plug);
  const auto held = plugged.controller->device().lock();
  return plugged.controller->driver(interfaceNumber);
}

std::string EmulatedUsb::devicePath(Plug plug) const { return m_impl->root + m_impl->at(plug).node; }

std::string EmulatedUsb::rootFolder() const { return m_impl->root; }

} // namespace straightedge::fakes
