// Listing, opening, claiming, plugging in and out: the real libusb on an emulated bus.
#include "devices/usb/access_remedy.h"
#include "devices/usb/usb_device.h"
#include "devices/usb/usb_handle.h"
#include "devices/usb/usb_hotplug.h"
#include "tests/fakes/usb/byte_stream_devices.h"
#include "tests/fakes/usb/emulated_usb.h"
#include "tests/fakes/usb/usbtmc_device.h"

#include <gmock/gmock.h>

#include <condition_variable>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <thread>
#include <unistd.h>

namespace straightedge::devices {
namespace {

using namespace std::chrono_literals;
using fakes::CdcAcmDevice;
using fakes::EmulatedUsb;
using fakes::FtdiDevice;
using fakes::UsbTmcDevice;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr auto generous = 60s; ///< for what has to come: fails only where it never does

std::shared_ptr<UsbTmcDevice> teslameter(std::string serial) {
  UsbTmcDevice::Options options;
  options.identity.serial = std::move(serial);
  return std::make_shared<UsbTmcDevice>(options);
}

TEST(UsbBus, NothingPluggedInIsAnEmptyListAndNoError) {
  const EmulatedUsb bus;
  const auto devices = listUsbDevices();
  ASSERT_TRUE(devices);
  EXPECT_THAT(*devices, IsEmpty());
}

TEST(UsbBus, ListsDescriptorsStringsPortsAndInterfacesWithoutOpening) {
  EmulatedUsb bus;
  bus.plug(teslameter("A1"), {.port = "7.1", .driver = "usbtmc"});
  bus.plug(std::make_shared<FtdiDevice>());
  bus.plug(std::make_shared<CdcAcmDevice>());
  const auto devices = listUsbDevices();
  ASSERT_TRUE(devices);
  ASSERT_THAT(*devices, SizeIs(3));
  const auto& meter = devices->at(0);
  EXPECT_EQ(meter.vendorId, 0x1bfa);
  EXPECT_EQ(meter.productId, 0x0498);
  EXPECT_EQ(meter.manufacturer, "Metrolab Technology SA");
  EXPECT_EQ(meter.product, "THM1176");
  EXPECT_EQ(meter.serial, "A1");
  EXPECT_EQ(meter.port, "1-7.1"); // the hub itself is left out
  EXPECT_EQ(meter.name(), "USB 1bfa:0498 serial A1");
  EXPECT_EQ(meter.problem, "");
  ASSERT_THAT(meter.interfaces, SizeIs(1));
  EXPECT_EQ(meter.interfaces[0].driver, "usbtmc");
  const auto* tmc = meter.findInterface(0xFE, 3);
  ASSERT_NE(tmc, nullptr);
  EXPECT_EQ(tmc->find(UsbEndpointType::Bulk, true)->address, UsbTmcDevice::in);
  EXPECT_EQ(tmc->find(UsbEndpointType::Bulk, false)->packetSize, 512);
  EXPECT_EQ(tmc->find(UsbEndpointType::Interrupt, true)->packetSize, 2);
  EXPECT_EQ(devices->at(1).release, 0x0600);
  EXPECT_THAT(devices->at(2).interfaces, SizeIs(2));
}

TEST(UsbBus, KernelDriverIsDetachedAndGivenBack) {
  EmulatedUsb bus;
  const auto plug = bus.plug(teslameter("A1"), {.driver = "usbtmc"});
  {
    const auto handle = UsbHandle::open(listUsbDevices()->at(0), {0});
    ASSERT_TRUE(handle) << handle.error().error.message();
    EXPECT_EQ(bus.driver(plug, 0), "usbfs");
  }
  EXPECT_EQ(bus.driver(plug, 0), "usbtmc");
}

TEST(UsbBus, WhatAnotherProgramHoldsIsBusyInTheListAndOnOpening) {
  EmulatedUsb bus;
  const auto plug = bus.plug(teslameter("A1"), {.heldByAnotherProgram = true});
  const auto device = listUsbDevices()->at(0);
  EXPECT_THAT(device.problem, HasSubstr("another program has the USB device open"));
  const auto refused = UsbHandle::open(device, {0});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().fault, UsbFault::Busy);
  EXPECT_THAT(refused.error().error.remedy, HasSubstr("close the program"));
  bus.letGo(plug);
  EXPECT_TRUE(UsbHandle::open(device, {0}));
}

TEST(UsbBus, OpenTwiceIsBusyUntilTheFirstIsClosed) {
  EmulatedUsb bus;
  bus.plug(teslameter("A1"));
  const auto device = listUsbDevices()->at(0);
  auto first = UsbHandle::open(device, {0});
  ASSERT_TRUE(first);
  const auto second = UsbHandle::open(device, {0});
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().fault, UsbFault::Busy);
  first->reset();
  EXPECT_TRUE(UsbHandle::open(device, {0}));
}

/// Takes root's rights from this thread only, so that the test means the same for root and for users.
class WithoutRights {
public:
  WithoutRights() {
    if (::geteuid() == 0) {
      m_changed = ::syscall(SYS_setresuid, 65534, 65534, 0) == 0;
    }
  }
  ~WithoutRights() {
    if (m_changed) {
      static_cast<void>(::syscall(SYS_setresuid, 0, 0, 0));
    }
  }
  WithoutRights(const WithoutRights&) = delete;
  WithoutRights& operator=(const WithoutRights&) = delete;

private:
  bool m_changed = false;
};

TEST(UsbBus, AccessDeniedSaysWhichCommandMendsIt) {
  EmulatedUsb bus;
  ASSERT_THAT(accessRemedy(), HasSubstr("/installer/run --udev")); // asked for before there are no rights to see /proc
  const auto plug = bus.plug(teslameter("A1"));
  ::chmod(bus.rootFolder().c_str(), 0777);                                  // the emulated udev makes its sockets there
  ::chmod((bus.rootFolder() + "/ioctl/dev/bus/usb/001/002").c_str(), 0777); // connected to even when opening fails
  ::chmod(bus.devicePath(plug).c_str(), 0);
  {
    const WithoutRights user;
    const auto device = listUsbDevices()->at(0);
    EXPECT_EQ(device.serial, "A1");
    EXPECT_THAT(device.problem, HasSubstr("/dev/bus/usb/001/002"));
    EXPECT_THAT(device.problem, HasSubstr("denied"));
    EXPECT_EQ(device.remedy, accessRemedy());
    const auto refused = UsbHandle::open(device, {0});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().fault, UsbFault::AccessDenied);
    EXPECT_EQ(refused.error().error.remedy, accessRemedy());
  }
  ::chmod(bus.devicePath(plug).c_str(), 0644);
  const auto device = listUsbDevices()->at(0);
  EXPECT_EQ(device.problem, "");
  EXPECT_TRUE(UsbHandle::open(device, {0}));
}

TEST(UsbBus, TwoEqualDevicesAreToldApartBySerialAndPort) {
  EmulatedUsb bus;
  bus.plug(teslameter("A1"), {.port = "1"});
  bus.plug(teslameter("A2"), {.port = "2"});
  const auto devices = *listUsbDevices();
  ASSERT_THAT(devices, SizeIs(2));
  EXPECT_EQ(devices[0].name(), "USB 1bfa:0498 serial A1");
  EXPECT_EQ(devices[1].name(), "USB 1bfa:0498 serial A2");
  EXPECT_EQ(devices[1].port, "1-2");
  EXPECT_TRUE(UsbHandle::open(devices[1], {0}));
}

TEST(UsbBus, OldSnapshotOfAReplacedDeviceIsGone) {
  EmulatedUsb bus;
  const auto meter = teslameter("A1");
  const auto plug = bus.plug(meter);
  const auto old = listUsbDevices()->at(0);
  bus.unplug(plug);
  bus.plug(meter, {.port = "4"});
  const auto refused = UsbHandle::open(old, {0});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().fault, UsbFault::Gone);
  const auto again = *listUsbDevices();
  ASSERT_THAT(again, SizeIs(1));
  EXPECT_EQ(again[0].serial, "A1");
  EXPECT_EQ(again[0].port, "1-4");
  EXPECT_TRUE(UsbHandle::open(again[0], {0}));
}

/// Collects what hotplug tells and waits for it.
class Watcher {
public:
  void take(const UsbHotplug::Change& change) {
    const std::scoped_lock lock(m_mutex);
    for (const auto& device : change.left) {
      m_told.push_back("-" + device.serial);
    }
    for (const auto& device : change.arrived) {
      m_told.push_back("+" + device.serial);
    }
    ++m_calls;
    m_changed.notify_all();
  }
  std::vector<std::string> waitFor(std::size_t count) {
    std::unique_lock lock(m_mutex);
    m_changed.wait_for(lock, generous, [&] { return m_told.size() >= count; });
    return m_told;
  }
  void waitForFirstCall() {
    std::unique_lock lock(m_mutex);
    m_changed.wait_for(lock, generous, [&] { return m_calls > 0; });
  }

private:
  std::mutex m_mutex;
  std::condition_variable m_changed;
  std::vector<std::string> m_told;
  int m_calls = 0;
};

TEST(UsbHotplugTest, TellsWhatIsThereWhatComesAndWhatLeavesByEvents) {
  EmulatedUsb bus;
  const auto meter = teslameter("A1");
  const auto plug = bus.plug(meter);
  Watcher watcher;
  // An hour between looks: only events can tell in time.
  const UsbHotplug hotplug([&](const auto& change) { watcher.take(change); }, 1h);
  ASSERT_THAT(watcher.waitFor(1), ElementsAre("+A1"));
  const auto second = bus.plug(teslameter("A2"));
  ASSERT_THAT(watcher.waitFor(2), ElementsAre("+A1", "+A2"));
  bus.unplug(plug);
  ASSERT_THAT(watcher.waitFor(3), ElementsAre("+A1", "+A2", "-A1"));
  bus.plug(meter, {.port = "7"});
  ASSERT_THAT(watcher.waitFor(4), ElementsAre("+A1", "+A2", "-A1", "+A1"));
  bus.unplug(second);
  ASSERT_THAT(watcher.waitFor(5), ElementsAre("+A1", "+A2", "-A1", "+A1", "-A2"));
}

TEST(UsbHotplugTest, WhatHasLeftButIsStillListedHasLeft) {
  EmulatedUsb bus;
  const auto plug = bus.plug(teslameter("A1"));
  Watcher watcher;
  const UsbHotplug hotplug([&](const auto& change) { watcher.take(change); }, 1h);
  ASSERT_THAT(watcher.waitFor(1), ElementsAre("+A1"));
  bus.tellLeaving(plug);
  ASSERT_THAT(watcher.waitFor(2), ElementsAre("+A1", "-A1"));
  ASSERT_THAT(*listUsbDevices(), SizeIs(1)) << "still listed";
  bus.unplug(plug);
}

TEST(UsbHotplugTest, WithoutEventsItLooksByItself) {
  EmulatedUsb bus;
  Watcher watcher;
  const UsbHotplug hotplug([&](const auto& change) { watcher.take(change); }, 5ms);
  watcher.waitForFirstCall();
  const auto plug = bus.plug(teslameter("A1"), {.events = false});
  ASSERT_THAT(watcher.waitFor(1), ElementsAre("+A1"));
  bus.unplug(plug);
  ASSERT_THAT(watcher.waitFor(2), ElementsAre("+A1", "-A1"));
}

TEST(UsbHotplugTest, EndsAtOnceWhileItWaits) {
  const EmulatedUsb bus;
  Watcher watcher;
  const UsbHotplug hotplug([&](const auto& change) { watcher.take(change); }, 1h);
  watcher.waitForFirstCall();
}

} // namespace
} // namespace straightedge::devices
