// SCPI instruments over USB: USBTMC with USB488, on any UsbPipe.
#pragma once

#include "devices/transport/transport.h"
#include "devices/transport/usbtmc_quirks.h"
#include "devices/transport/usbtmc_wire.h"
#include "devices/usb/usb_device.h"
#include "devices/usb/usb_pipe.h"

#include <deque>
#include <memory>
#include <vector>

namespace straightedge::devices {

/// What of a device's interface the protocol needs.
struct UsbTmcChannel {
  std::uint8_t interfaceNumber = 0;
  UsbEndpoint out;
  UsbEndpoint in;
  std::optional<UsbEndpoint> interrupt; ///< of a USB488 interface only
};

struct UsbTmcOptions {
  std::uint32_t requestSize = 65536; ///< bytes to ask for at a time; a longer reply comes in several transfers
  std::uint32_t messageSize = 65536; ///< bytes to send at a time
  Milliseconds recoveryTime = Milliseconds(1000); ///< for a whole abort or clear
  UsbTmcQuirks quirks = {};
};

/// A message that was refused, timed out or came back damaged leaves the device ready for the next one: transfers are
/// aborted and halts cleared before the error is returned, which may take up to `recoveryTime` each beyond the
/// deadline. Where an old answer may still be on its way, the next write() clears the device first, so that it is never
/// taken for the new one.
class UsbTmcTransport final : public Transport {
public:
  /// The first USBTMC interface of the device, or null if it has none.
  static const UsbInterface* interfaceOf(const UsbDevice& device);

  static TransportResult<std::unique_ptr<UsbTmcTransport>> open(const UsbDevice& device);

  /// Over a pipe that is open already. Resets, listens and asks for capabilities as the device needs it.
  static TransportResult<std::unique_ptr<UsbTmcTransport>> start(std::unique_ptr<UsbPipe> pipe, std::string name,
                                                                 const UsbTmcChannel& channel,
                                                                 const UsbTmcOptions& options = {});
  ~UsbTmcTransport() override;

  std::string name() const override { return m_name; }
  bool hasMessages() const override { return true; }

  /// Protocol if the answer to a query before was not read: the device would drop it (IEEE 488.2 INTERRUPTED).
  TransportResult<void> write(std::string_view bytes, Milliseconds deadline) override;

  /// Protocol if nothing was asked: the device would never answer.
  TransportResult<std::string> read(Milliseconds deadline) override;

  /// The end of a message counts as the end of its last line.
  TransportResult<std::string> readUntil(std::string_view end, Milliseconds deadline) override;

  TransportResult<void> clear() override;
  TransportResult<std::uint8_t> statusByte(Milliseconds deadline) override;

  /// Waits until the device requests service (SRQ) and returns the status byte it sent. Unsupported without an
  /// interrupt endpoint.
  TransportResult<std::uint8_t> waitForServiceRequest(Milliseconds deadline);

  /// USB488 TRIGGER. Unsupported where the device does not know it.
  TransportResult<void> trigger(Milliseconds deadline);

  const usbtmc::Capabilities& capabilities() const { return m_capabilities; }

private:
  class Deadline;
  UsbTmcTransport(std::unique_ptr<UsbPipe> pipe, std::string name, const UsbTmcChannel& channel,
                  const UsbTmcOptions& options);

  TransportResult<void> prepare();
  TransportResult<void> sendMessage(std::string_view bytes, const Deadline& deadline);
  TransportResult<void> sendHeader(const usbtmc::Header& header, const Deadline& deadline);
  TransportResult<void> sendOut(std::span<const std::uint8_t> bytes, std::uint8_t tag, const Deadline& deadline);
  TransportResult<void> receivePart(const std::uint8_t* termChar, const Deadline& deadline);
  TransportResult<std::span<const std::uint8_t>> receiveTransfer(std::uint8_t tag, const Deadline& deadline);
  TransportResult<void> receiveRest(std::size_t announced, const Deadline& deadline);
  TransportResult<void> checkedPart(std::span<const std::uint8_t> transfer, std::uint8_t tag, std::uint32_t requested);
  std::unexpected<TransportError> damaged(std::string what, std::uint8_t tag);
  std::unexpected<TransportError> misused(std::string what, std::string remedy) const;
  std::unexpected<TransportError> failed(UsbError error) const;

  // usbtmc_recovery.cpp
  void abortIn(std::uint8_t tag);
  void abortOut(std::uint8_t tag);
  void awaitEndOfAbort(usbtmc::Request check, std::uint8_t endpoint);
  void drainIn();
  TransportResult<void> clearByRequest();
  void clearByReading();
  UsbResult<std::size_t> ask(std::uint8_t to, usbtmc::Request request, std::uint16_t value, std::uint16_t index,
                             std::span<std::uint8_t> answer, Milliseconds deadline);
  void forgetReply();

  // usbtmc_status.cpp
  void takeNotifications();
  TransportResult<std::uint8_t> notifiedStatus(std::uint8_t tag, const Deadline& deadline);

  std::unique_ptr<UsbPipe> m_pipe;
  std::string m_name;
  UsbTmcChannel m_channel;
  UsbTmcOptions m_options;
  usbtmc::Capabilities m_capabilities;
  std::uint8_t m_tag = 0;       ///< of the last header sent
  std::uint8_t m_statusTag = 1; ///< of the last READ_STATUS_BYTE: 2 … 127
  std::deque<std::uint8_t> m_serviceRequests;
  std::vector<std::uint8_t> m_out;
  std::vector<std::uint8_t> m_in;
  std::string m_received;        ///< of the reply, not yet handed out
  std::string m_unansweredQuery; ///< a query whose reply has not been read to its end; for the message
  bool m_replyDue = false;       ///< something was sent and its reply has not been read to its end
  bool m_ended = false;          ///< m_received holds the end of the reply
  bool m_stale = false;          ///< an old reply may still come: clear before the next message
};

} // namespace straightedge::devices
