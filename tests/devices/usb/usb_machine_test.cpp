// On this machine as it is, with USB or without any: nothing fails and nothing waits.
#include "devices/usb/usb_device.h"
#include "devices/usb/usb_handle.h"
#include "devices/usb/usb_hotplug.h"

#include <gtest/gtest.h>

#include <future>

namespace straightedge::devices {
namespace {

TEST(UsbMachine, ListingIsNoErrorWhateverIsThere) {
  for (int i = 0; i < 5; ++i) {
    const auto devices = listUsbDevices();
    EXPECT_TRUE(devices) << devices.error().error.message();
  }
}

TEST(UsbMachine, WhatIsNotThereIsGone) {
  const auto refused = UsbHandle::open({.vendorId = 0x1bfa, .productId = 0x0498, .bus = 255, .address = 255}, {0});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().fault, UsbFault::Gone);
  EXPECT_EQ(refused.error().error.kind, ErrorKind::Instrument);
}

TEST(UsbMachine, HotplugTellsTheBeginningAndEnds) {
  std::promise<void> told;
  bool first = true;
  const UsbHotplug hotplug([&](const auto&) {
    if (std::exchange(first, false)) {
      told.set_value();
    }
  });
  EXPECT_EQ(told.get_future().wait_for(std::chrono::seconds(60)), std::future_status::ready);
}

} // namespace
} // namespace straightedge::devices
