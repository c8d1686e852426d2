// A serial line through libusb, without the kernel's driver: CDC-ACM boards and FTDI adapters.
#pragma once

#include "devices/transport/byte_buffer.h"
#include "devices/transport/serial_settings.h"
#include "devices/transport/transport.h"
#include "devices/transport/usb_serial_chip.h"

#include <memory>

namespace straightedge::devices {

/// Reads stay posted from the opening on, so that an instrument that streams loses nothing between two reads. What came
/// before a fault is handed out before it; TimedOut keeps what came for the next call. Bytes that the adapter itself
/// lost are an error (Overflow), damaged ones too (Protocol); the next read goes on after them.
class UsbSerialTransport final : public Transport {
public:
  /// Whether the device is a serial line that this can drive.
  static bool canOpen(const UsbDevice& device);

  /// A kernel driver that holds it is detached and given back. Errors as UsbHandle::open(), and Unsupported for
  /// settings.
  static TransportResult<std::unique_ptr<UsbSerialTransport>> open(const UsbDevice& device,
                                                                   const SerialSettings& settings);

  /// Over a pipe that is open already.
  static TransportResult<std::unique_ptr<UsbSerialTransport>> start(std::unique_ptr<UsbPipe> pipe, std::string name,
                                                                    std::unique_ptr<UsbSerialChip> chip,
                                                                    const SerialSettings& settings);

  std::string name() const override { return m_name; }
  TransportResult<void> write(std::string_view bytes, Milliseconds deadline) override;
  TransportResult<std::string> read(Milliseconds deadline) override;
  TransportResult<std::string> readUntil(std::string_view end, Milliseconds deadline) override;
  TransportResult<void> clear() override;

  TransportResult<void> setControlLines(bool dtr, bool rts);

private:
  using Clock = std::chrono::steady_clock;
  UsbSerialTransport(std::unique_ptr<UsbPipe> pipe, std::string name, std::unique_ptr<UsbSerialChip> chip)
      : m_pipe(std::move(pipe)), m_chip(std::move(chip)), m_name(std::move(name)) {}

  TransportResult<void> receive(Clock::time_point until);
  std::unexpected<TransportError> failed(TransportFault fault, std::string what, std::string remedy) const;

  std::unique_ptr<UsbPipe> m_pipe;
  std::unique_ptr<UsbSerialChip> m_chip;
  std::string m_name;
  ByteBuffer m_received;
};

} // namespace straightedge::devices
