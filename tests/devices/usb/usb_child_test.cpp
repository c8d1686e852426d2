// The emulated bus serves other programs too: the real ones run against it as children.
#include "tests/fakes/usb/byte_stream_devices.h"
#include "tests/fakes/usb/emulated_usb.h"
#include "tests/fakes/usb/usbtmc_device.h"

#include <gmock/gmock.h>

#include <array>
#include <cstdio>

namespace straightedge::fakes {
namespace {

std::string outputOfChild() {
  std::string output;
  FILE* pipe = ::popen(STRAIGHTEDGE_BINARY_DIR "/usb_child 2>&1", "r");
  std::array<char, 256> bytes{};
  while (std::fgets(bytes.data(), static_cast<int>(bytes.size()), pipe) != nullptr) {
    output += bytes.data();
  }
  EXPECT_EQ(::pclose(pipe), 0);
  return output;
}

TEST(UsbChild, FindsAndAsksTheEmulatedInstrument) {
  EmulatedUsb bus;
  auto meter = std::make_shared<UsbTmcDevice>();
  meter->onMessage([](const std::string& message) {
    return message == "*IDN?" ? std::optional<std::string>("Metrolab,THM1176") : std::nullopt;
  });
  const auto plug = bus.plug(meter, {.driver = "usbtmc"});
  bus.plug(std::make_shared<FtdiDevice>());
  EXPECT_EQ(outputOfChild(), "USB 1bfa:0498 serial 0123456\nMetrolab,THM1176\nUSB 0403:6001 serial FT-1\n");
  EXPECT_EQ(bus.driver(plug, 0), "usbtmc");
  bus.unplug(plug);
  EXPECT_EQ(outputOfChild(), "USB 0403:6001 serial FT-1\n");
  EXPECT_THAT(meter->violations(), testing::IsEmpty());
}

TEST(UsbChild, IsToldThatAnotherProgramHoldsTheInstrument) {
  EmulatedUsb bus;
  bus.plug(std::make_shared<UsbTmcDevice>(), {.heldByAnotherProgram = true});
  EXPECT_THAT(outputOfChild(), testing::HasSubstr("another program has the USB device open; close the program"));
}

} // namespace
} // namespace straightedge::fakes
