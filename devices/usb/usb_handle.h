// An opened device over libusb. Each has a libusb context of its own, so that the threads of two instruments never wait
// for one another.
#pragma once

#include "devices/usb/usb_device.h"
#include "devices/usb/usb_pipe.h"

#include <memory>
#include <stop_token>

namespace straightedge::devices {

class UsbHandle final : public UsbPipe {
public:
  /// Opens the device of the snapshot and claims these interfaces; a kernel driver that holds one is detached, and
  /// given back when this is destroyed. Gone when the device was unplugged since the snapshot, even if it is back: list
  /// again.
  static UsbResult<std::unique_ptr<UsbHandle>> open(const UsbDevice& device, std::vector<std::uint8_t> interfaces);

  ~UsbHandle() override;
  UsbHandle(const UsbHandle&) = delete;
  UsbHandle& operator=(const UsbHandle&) = delete;

  /// Ends a transfer that waits, and every later one, with Cancelled. To be set before transfers; requested from any
  /// thread.
  void setStop(std::stop_token stop);

  std::string name() const override;
  UsbResult<std::size_t> bulkOut(std::uint8_t endpoint, std::span<const std::uint8_t> bytes,
                                 std::chrono::milliseconds deadline) override;
  UsbResult<std::size_t> bulkIn(std::uint8_t endpoint, std::span<std::uint8_t> buffer,
                                std::chrono::milliseconds deadline) override;
  UsbResult<std::size_t> control(const UsbSetup& setup, std::span<std::uint8_t> data,
                                 std::chrono::milliseconds deadline) override;
  UsbResult<void> clearHalt(std::uint8_t endpoint) override;
  UsbResult<void> reset() override;
  UsbResult<void> startReading(std::uint8_t endpoint, std::size_t size, std::size_t count) override;
  UsbResult<std::vector<std::uint8_t>> nextRead(std::uint8_t endpoint, std::chrono::milliseconds deadline) override;

private:
  struct Impl;
  explicit UsbHandle(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> m_impl;
};

} // namespace straightedge::devices
