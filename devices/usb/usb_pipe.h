// An opened USB device as a protocol sees it: its endpoints. UsbHandle is the one over libusb; tests and benchmarks put
// a pipe in the process behind the same protocols.
#pragma once

#include "devices/usb/usb_error.h"

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace straightedge::devices {

/// A request to endpoint 0; bit 7 of requestType says that the device answers. wLength is the size of the data.
struct UsbSetup {
  std::uint8_t requestType = 0;
  std::uint8_t request = 0;
  std::uint16_t value = 0;
  std::uint16_t index = 0;
};

/// Thread: one at a time. Every member may block up to its deadline; a deadline that passed takes the transfer back and
/// says TimedOut with the bytes that had come.
class UsbPipe {
public:
  virtual ~UsbPipe() = default;

  /// For messages: "USB 1bfa:0498 serial 0123".
  virtual std::string name() const = 0;

  /// All of `bytes`, or an error that says how many had gone.
  virtual UsbResult<std::size_t> bulkOut(std::uint8_t endpoint, std::span<const std::uint8_t> bytes,
                                         std::chrono::milliseconds deadline) = 0;

  /// Ends with a short packet or a full buffer; returns the number of bytes, which may be 0.
  virtual UsbResult<std::size_t> bulkIn(std::uint8_t endpoint, std::span<std::uint8_t> buffer,
                                        std::chrono::milliseconds deadline) = 0;

  /// `data` is sent or filled, as the setup says; returns the number of bytes.
  virtual UsbResult<std::size_t> control(const UsbSetup& setup, std::span<std::uint8_t> data,
                                         std::chrono::milliseconds deadline) = 0;

  /// CLEAR_FEATURE(ENDPOINT_HALT), and the host's data toggle with it.
  virtual UsbResult<void> clearHalt(std::uint8_t endpoint) = 0;

  /// Resets the device at its port and restores its configuration.
  virtual UsbResult<void> reset() = 0;

  /// Keeps `count` reads of `size` bytes posted on an IN endpoint from now on, so that what arrives while nobody waits
  /// is not lost. On an interrupt endpoint `size` is one packet: a longer read would swallow several notifications at
  /// once. To be called once per endpoint; that endpoint is then read with nextRead() only.
  virtual UsbResult<void> startReading(std::uint8_t endpoint, std::size_t size, std::size_t count) = 0;

  /// The oldest bytes that were not yet taken, never none; TimedOut when none came. A deadline of 0 looks and does not
  /// wait. Stalled and Overflow clear the halt and post the reads anew.
  virtual UsbResult<std::vector<std::uint8_t>> nextRead(std::uint8_t endpoint, std::chrono::milliseconds deadline) = 0;
};

} // namespace straightedge::devices
