// An engineer's desk on the emulated bus: a QSB encoder reader and a board that prints angles, on one shaft that the
// test turns.
#pragma once

#include "tests/fakes/usb/byte_stream_devices.h"
#include "tests/fakes/usb/emulated_usb.h"

#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <string>

namespace straightedge::fakes {

inline constexpr int deskCountsPerTurn = 3600;

struct DeskShaft {
  std::atomic<double> angleDeg = 0.0;
  std::atomic<int> leavesAfter = -1; ///< answers of the encoder reader until it is unplugged inside one; -1: never
  std::atomic<int> asked = 0;        ///< times that the encoder reader was asked for its count
  std::atomic<int> printed = 0;      ///< lines that the board gave to the host
};

/// The sensor's angle with an error that a calibration finds again.
inline double deskSensorDeg(double angleDeg) {
  const double shifted = angleDeg + 3.0 * std::sin(angleDeg * std::numbers::pi / 180.0) + 20.0;
  return shifted - 360.0 * std::floor(shifted / 360.0);
}

inline std::shared_ptr<FtdiDevice> deskEncoder(DeskShaft& shaft) {
  auto device = std::make_shared<FtdiDevice>();
  device->onLine("\r\n", [&shaft, raw = device.get()](const std::string& line) -> std::string {
    unsigned data = 0;
    if (line == "R14") {
      data = 0x12345009;
    } else if (line == "R0E") {
      ++shaft.asked;
      if (shaft.leavesAfter >= 0 && shaft.leavesAfter-- == 0) {
        raw->unplugAfter(4);
      }
      data = static_cast<unsigned>(std::lround(shaft.angleDeg / 360.0 * deskCountsPerTurn));
    }
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%c %s %08X 00000001 !\r\n", line.starts_with('W') ? 'w' : 'r',
                  line.substr(1, 2).c_str(), data);
    return text.data();
  });
  return device;
}

inline std::shared_ptr<CdcAcmDevice> deskBoard(DeskShaft& shaft) {
  auto device = std::make_shared<CdcAcmDevice>();
  device->generate([&shaft, next = std::chrono::steady_clock::now()]() mutable -> std::string {
    const auto now = std::chrono::steady_clock::now();
    if (now < next) {
      return {};
    }
    next = now + std::chrono::milliseconds(2);
    ++shaft.printed;
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4f\r\n", deskSensorDeg(shaft.angleDeg));
    return text.data();
  });
  return device;
}

} // namespace straightedge::fakes
