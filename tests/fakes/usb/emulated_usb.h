// An emulated USB bus under the real libusb (umockdev): a small host controller that answers the usbfs ioctls of this
// process and of its children. Programs that use it run with LD_PRELOAD=libumockdev-preload.so.0, which
// straightedge_add_usb_test() in tests/fakes/usb/fakes.cmake arranges.
//
//   EmulatedUsb bus;                                      // one at a time per process
//   auto meter = std::make_shared<UsbTmcDevice>(UsbTmcDevice::Options{.identity = {0x1bfa, 0x0498, "Metrolab",
//   "THM1176", "0123"}}); meter->onMessage([](const std::string& m) { return m == "*IDN?" ?
//   std::optional<std::string>("Metrolab,…") : std::nullopt; }); const auto plug = bus.plug(meter); // listUsbDevices()
//   now shows it; hotplug tells it … run code of ours here, or start the real program as a child: it inherits
//   UMOCKDEV_DIR and LD_PRELOAD … bus.unplug(plug); EXPECT_THAT(meter->violations(), IsEmpty());          // the host
//   kept the protocol
//
// Devices: UsbTmcDevice (usbtmc_device.h), CdcAcmDevice and FtdiDevice (byte_stream_devices.h), or one of your own.
#pragma once

#include "tests/fakes/usb/emulated_device.h"

#include <memory>
#include <string>

namespace straightedge::fakes {

struct PlugOptions {
  std::string port = {};   ///< "3" or "3.1"; the next free one if empty
  std::string driver = {}; ///< kernel driver that holds every interface, detachable: "usbtmc", "cdc_acm", "ftdi_sio"
  bool heldByAnotherProgram = false; ///< claiming says busy
  bool events = true;                ///< false: no udev event tells of this device's arrival and leaving
};

/// Thread: plug, unplug and queries from the test's thread; the devices are served in a thread of umockdev's.
class EmulatedUsb {
public:
  using Plug = int;

  EmulatedUsb();
  ~EmulatedUsb();
  EmulatedUsb(const EmulatedUsb&) = delete;
  EmulatedUsb& operator=(const EmulatedUsb&) = delete;

  Plug plug(std::shared_ptr<EmulatedDevice> device, const PlugOptions& options = {});
  void unplug(Plug plug);
  /// The event of its leaving while it is still listed, as for a moment on a real kernel; unplug() is to follow.
  void tellLeaving(Plug plug);
  bool isPlugged(Plug plug) const; ///< false too after a device left by itself

  void letGo(Plug plug); ///< the other program has closed it

  /// The driver on the interface now: "usbfs" while a program under test has claimed it, empty when none.
  std::string driver(Plug plug, int interfaceNumber) const;

  std::string devicePath(Plug plug) const; ///< of the device node inside the testbed's folder, for chmod
  std::string rootFolder() const;

private:
  struct Impl;
  std::unique_ptr<Impl> m_impl;
};

} // namespace straightedge::fakes
