// What differs between USB serial adapters: how the line is set up and how its bytes are packed.
#pragma once

#include "devices/transport/serial_settings.h"
#include "devices/usb/usb_device.h"
#include "devices/usb/usb_pipe.h"

#include <memory>
#include <string>

namespace straightedge::devices {

/// What is wrong with the bytes of a read, as the adapter tells.
struct LineErrors {
  bool overrun = false; ///< bytes were lost in the adapter
  bool parity = false;
  bool framing = false;
  bool any() const { return overrun || parity || framing; }
};

/// Thread: the transport's.
class UsbSerialChip {
public:
  virtual ~UsbSerialChip() = default;

  virtual std::vector<std::uint8_t> interfaces() const = 0; ///< to claim
  virtual UsbEndpoint in() const = 0;
  virtual UsbEndpoint out() const = 0;

  /// The first of the settings that the adapter cannot do, in words; empty if it can do them all.
  virtual std::string refuses(const SerialSettings& settings) const = 0;

  virtual UsbResult<void> setUp(UsbPipe& pipe, const SerialSettings& settings) = 0;
  virtual UsbResult<void> setControlLines(UsbPipe& pipe, bool dtr, bool rts) = 0;

  /// Empties the adapter's buffers, where it has a request for that.
  virtual UsbResult<void> empty(UsbPipe& pipe) = 0;

  /// Appends the line's bytes out of one transfer.
  virtual LineErrors unpack(std::span<const std::uint8_t> transfer, std::string& bytes) const = 0;
};

/// Null where the device is none.
std::unique_ptr<UsbSerialChip> cdcAcmChip(const UsbDevice& device);
std::unique_ptr<UsbSerialChip> ftdiChip(const UsbDevice& device);

} // namespace straightedge::devices
