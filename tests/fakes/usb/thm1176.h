// What a Metrolab THM1176 says, for the emulated USBTMC device that stands for one.
#pragma once

#include "tests/fakes/usb/usbtmc_device.h"

#include <functional>
#include <optional>
#include <string>
#include <utility>

namespace straightedge::fakes {

inline constexpr const char* thm1176Reading = "0.25 T;-0.5 T;1 T;0x0;100;0";

/// For UsbTmcDevice::onMessage(): who it is (serial number 0123456), that nothing went wrong, and `reading` where
/// readings are fetched; everything else is a command. `reading` is called in the device's thread.
inline UsbTmcDevice::Handler thm1176Answers(std::function<std::string()> reading = [] {
  return std::string(thm1176Reading);
}) {
  return [reading = std::move(reading)](const std::string& message) -> std::optional<std::string> {
    if (message == "*IDN?") {
      return "Metrolab Technology SA,THM1176-MF,0123456,el-A1-K1";
    }
    if (message == ":SYST:ERR?") {
      return R"(0,"No error")";
    }
    return message.starts_with(":FETC") ? std::optional(reading()) : std::nullopt;
  };
}

} // namespace straightedge::fakes
