#include "devices/transport/usbtmc_quirks.h"

#include <array>

namespace straightedge::devices {

namespace {

// None of these was tried on hardware here: each follows the source it names.
constexpr std::array quirkTable = {
    UsbTmcQuirkEntry{.vendorId = 0x1bfa,
                     .productId = 0x0498,
                     .model = "Metrolab THM1176, TFM1186",
                     .source = "Hyperfine/pyTHM1176 (resets at open); its transfers are limited to 49216 bytes",
                     .quirks = {.resetAtOpen = true, .largestRequest = 49152}},
    UsbTmcQuirkEntry{
        .vendorId = 0x1ab1,
        .productId = 0x0588,
        .model = "Rigol DS1000",
        .source = "python-ivi/python-usbtmc pull requests 18 and 62, libsigrok",
        .quirks = {.noRemoteControl = true, .noClear = true, .headerOnlyOnce = true, .largestRequest = 500}},
    UsbTmcQuirkEntry{
        .vendorId = 0x1ab1,
        .productId = 0x04ce,
        .model = "Rigol DS1000Z",
        .source = "python-ivi/python-usbtmc pull requests 18 and 62, libsigrok",
        .quirks = {.noRemoteControl = true, .noClear = true, .headerOnlyOnce = true, .largestRequest = 500}},
    UsbTmcQuirkEntry{.vendorId = 0x1ab1,
                     .productId = 0,
                     .model = "Rigol",
                     .source = "libsigrok scpi_usbtmc_libusb.c",
                     .quirks = {.noRemoteControl = true}},
    UsbTmcQuirkEntry{.vendorId = 0x0b21,
                     .productId = 0,
                     .model = "Yokogawa",
                     .source = "libsigrok scpi_usbtmc_libusb.c",
                     .quirks = {.noRemoteControl = true}},
    UsbTmcQuirkEntry{.vendorId = 0xf4ec,
                     .productId = 0,
                     .model = "Siglent",
                     .source = "libsigrok scpi_usbtmc_libusb.c",
                     .quirks = {.resetAtOpen = true, .noRemoteControl = true}},
    UsbTmcQuirkEntry{.vendorId = 0x1334,
                     .productId = 0,
                     .model = "Advantest",
                     .source = "python-ivi/python-usbtmc",
                     .quirks = {.noEndOfMessage = true, .largestRequest = 63}},
};

} // namespace

std::span<const UsbTmcQuirkEntry> usbTmcQuirkTable() { return quirkTable; }

UsbTmcQuirks usbTmcQuirks(std::uint16_t vendorId, std::uint16_t productId) {
  for (const std::uint16_t product : {productId, std::uint16_t{0}}) {
    for (const auto& entry : quirkTable) {
      if (entry.vendorId == vendorId && entry.productId == product) {
        return entry.quirks;
      }
    }
  }
  return {};
}

} // namespace straightedge::devices
