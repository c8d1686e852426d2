#include "devices/transport/usbtmc_transport.h"

#include "devices/transport/usb_faults.h"
#include "devices/transport/usbtmc_deadline.h"
#include "devices/usb/usb_handle.h"

namespace straightedge::devices {

namespace {

constexpr Milliseconds startTime(5000); ///< for each request while starting

/// IEEE 488.2: a query has a question mark in its header; one inside a quoted text is data.
bool isQuery(std::string_view message) {
  char quote = 0;
  for (const char c : message) {
    if (quote != 0) {
      quote = c == quote ? '\0' : quote;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '?') {
      return true;
    }
  }
  return false;
}

std::string shortened(std::string_view message) {
  constexpr std::size_t longest = 40;
  const auto end = message.find_first_of("\r\n");
  const auto line = message.substr(0, end);
  return line.size() <= longest ? std::string(line) : std::string(line.substr(0, longest)) + "…";
}

/// Bytes of an IEEE 488.2 definite block with its header, "#3128…": 5 + 128; 0 if it is none.
std::size_t blockSize(std::span<const std::uint8_t> data) {
  if (data.size() < 2 || data[0] != '#' || data[1] < '1' || data[1] > '9') {
    return 0;
  }
  const std::size_t digits = data[1] - std::size_t{'0'};
  std::size_t size = 0;
  for (std::size_t i = 0; i < digits && 2 + i < data.size(); ++i) {
    size = size * 10 + (data[2 + i] - std::size_t{'0'});
  }
  return 2 + digits + size;
}

} // namespace

const UsbInterface* UsbTmcTransport::interfaceOf(const UsbDevice& device) {
  const auto* found = device.findInterface(usbtmc::interfaceClass, usbtmc::interfaceSubclass);
  const bool complete = found != nullptr && found->find(UsbEndpointType::Bulk, false) != nullptr &&
                        found->find(UsbEndpointType::Bulk, true) != nullptr;
  return complete ? found : nullptr;
}

TransportResult<std::unique_ptr<UsbTmcTransport>> UsbTmcTransport::open(const UsbDevice& device) {
  const std::string name = "USBTMC " + device.label();
  const auto* interface = interfaceOf(device);
  if (interface == nullptr) {
    return std::unexpected(TransportError{
        TransportFault::Unsupported,
        Error{ErrorKind::Instrument, "this USB device has no USBTMC interface",
              "choose another connection for it; some instruments switch USBTMC on in their menu", name}});
  }
  auto handle = UsbHandle::open(device, {interface->number});
  if (!handle) {
    return std::unexpected(transportError(std::move(handle.error()), name));
  }
  UsbTmcChannel channel{.interfaceNumber = interface->number,
                        .out = *interface->find(UsbEndpointType::Bulk, false),
                        .in = *interface->find(UsbEndpointType::Bulk, true),
                        .interrupt = std::nullopt};
  const auto* interrupt = interface->find(UsbEndpointType::Interrupt, true);
  if (interface->protocol == usbtmc::protocolUsb488 && interrupt != nullptr) {
    channel.interrupt = *interrupt;
  }
  return start(std::move(*handle), name, channel, {.quirks = usbTmcQuirks(device.vendorId, device.productId)});
}

TransportResult<std::unique_ptr<UsbTmcTransport>> UsbTmcTransport::start(std::unique_ptr<UsbPipe> pipe,
                                                                         std::string name, const UsbTmcChannel& channel,
                                                                         const UsbTmcOptions& options) {
  std::unique_ptr<UsbTmcTransport> transport(new UsbTmcTransport(std::move(pipe), std::move(name), channel, options));
  if (auto ready = transport->prepare(); !ready) {
    return std::unexpected(std::move(ready.error()));
  }
  return transport;
}

UsbTmcTransport::UsbTmcTransport(std::unique_ptr<UsbPipe> pipe, std::string name, const UsbTmcChannel& channel,
                                 const UsbTmcOptions& options)
    : m_pipe(std::move(pipe)), m_name(std::move(name)), m_channel(channel), m_options(options) {
  if (m_options.quirks.largestRequest > 0) {
    m_options.requestSize = std::min(m_options.requestSize, m_options.quirks.largestRequest);
  }
}

UsbTmcTransport::~UsbTmcTransport() {
  if (m_capabilities.remoteControl && !m_options.quirks.noRemoteControl) {
    std::array<std::uint8_t, 1> status{};
    // Gives the front panel back; a device that is gone needs none.
    static_cast<void>(
        ask(usbtmc::toInterface, usbtmc::Request::GoToLocal, 0, m_channel.interfaceNumber, status, Milliseconds(200)));
  }
}

TransportResult<void> UsbTmcTransport::prepare() {
  if (m_options.quirks.resetAtOpen) {
    if (auto reset = m_pipe->reset(); !reset && reset.error().fault == UsbFault::Gone) {
      return failed(std::move(reset.error()));
    }
  }
  if (m_channel.interrupt) {
    auto listening = m_pipe->startReading(m_channel.interrupt->address, m_channel.interrupt->packetSize, 1);
    if (!listening) {
      return failed(std::move(listening.error()));
    }
  }
  std::array<std::uint8_t, 0x18> answer{};
  const auto size =
      ask(usbtmc::toInterface, usbtmc::Request::GetCapabilities, 0, m_channel.interfaceNumber, answer, startTime);
  if (size) {
    m_capabilities = usbtmc::readCapabilities(std::span(answer).first(*size));
  } else if (size.error().fault != UsbFault::Stalled) {
    return failed(size.error());
  }
  if (m_capabilities.remoteControl && !m_options.quirks.noRemoteControl) {
    std::array<std::uint8_t, 1> status{};
    // What refuses to be remote may still answer.
    static_cast<void>(
        ask(usbtmc::toInterface, usbtmc::Request::RemoteControl, 1, m_channel.interfaceNumber, status, startTime));
  }
  m_stale = !m_options.quirks.noClear; // whatever an earlier program left unread
  return {};
}

TransportResult<void> UsbTmcTransport::write(std::string_view bytes, Milliseconds time) {
  const Deadline deadline(time);
  if (!m_unansweredQuery.empty() || !m_received.empty()) {
    return misused("the answer to '" + m_unansweredQuery + "' has not been read",
                   "read it, or clear the connection, before the next command");
  }
  if (bytes.empty()) {
    return {};
  }
  if (m_stale) {
    auto cleared = clear();
    const bool refused = !cleared && (cleared.error().fault == TransportFault::Stalled ||
                                      cleared.error().fault == TransportFault::Protocol);
    if (!cleared && !refused) { // refused: it knows no clear, and nothing more can be done
      return cleared;
    }
    m_stale = false;
  }
  auto sent = sendMessage(bytes, deadline);
  if (!sent) {
    return sent;
  }
  m_replyDue = true;
  m_ended = false;
  if (isQuery(bytes)) {
    m_unansweredQuery = shortened(bytes);
  }
  return {};
}

TransportResult<void> UsbTmcTransport::sendMessage(std::string_view bytes, const Deadline& deadline) {
  for (std::size_t from = 0; from < bytes.size(); from += m_options.messageSize) {
    const auto part = bytes.substr(from, m_options.messageSize);
    const bool last = from + part.size() == bytes.size();
    m_tag = usbtmc::nextTag(m_tag);
    const auto header = usbtmc::messageHeader(m_tag, static_cast<std::uint32_t>(part.size()), last);
    m_out.assign(header.begin(), header.end());
    m_out.insert(m_out.end(), part.begin(), part.end());
    m_out.resize(usbtmc::paddedSize(m_out.size()), 0);
    if (auto sent = sendOut(m_out, m_tag, deadline); !sent) {
      m_stale = m_stale || from > 0; // the device holds the beginning of a message
      return sent;
    }
  }
  return {};
}

TransportResult<void> UsbTmcTransport::sendHeader(const usbtmc::Header& header, const Deadline& deadline) {
  return sendOut(header, header[1], deadline);
}

TransportResult<void> UsbTmcTransport::sendOut(std::span<const std::uint8_t> bytes, std::uint8_t tag,
                                               const Deadline& deadline) {
  auto sent = m_pipe->bulkOut(m_channel.out.address, bytes, deadline.left());
  if (sent) {
    return {};
  }
  switch (sent.error().fault) {
  case UsbFault::TimedOut:
  case UsbFault::Cancelled:
    abortOut(tag);
    m_stale = true;
    break;
  case UsbFault::Stalled:
    static_cast<void>(m_pipe->clearHalt(m_channel.out.address)); // the error to tell is the stall
    break;
  case UsbFault::Gone:
    break;
  default:
    m_stale = true;
  }
  return failed(std::move(sent.error()));
}

TransportResult<std::string> UsbTmcTransport::read(Milliseconds time) {
  const Deadline deadline(time);
  if (!m_replyDue && m_received.empty()) {
    return misused("nothing was asked that could be answered", "send a query before reading");
  }
  while (!m_ended) {
    if (auto part = receivePart(nullptr, deadline); !part) {
      forgetReply();
      return std::unexpected(std::move(part.error()));
    }
  }
  auto reply = std::move(m_received);
  forgetReply();
  return reply;
}

TransportResult<std::string> UsbTmcTransport::readUntil(std::string_view end, Milliseconds time) {
  const Deadline deadline(time);
  if (!m_replyDue && m_received.empty()) {
    return misused("nothing was asked that could be answered", "send a query before reading");
  }
  const bool byChar = m_capabilities.termChar && end.size() == 1;
  const auto termChar = byChar ? static_cast<std::uint8_t>(end.front()) : std::uint8_t{0};
  while (true) {
    const auto at = m_received.find(end);
    if (at != std::string::npos && at + end.size() < m_received.size()) {
      auto line = m_received.substr(0, at + end.size());
      m_received.erase(0, line.size());
      return line;
    }
    if (at != std::string::npos || m_ended) {
      auto line = std::move(m_received);
      m_received.clear();
      if (m_ended) {
        forgetReply();
      }
      return line;
    }
    if (auto part = receivePart(byChar ? &termChar : nullptr, deadline); !part) {
      forgetReply();
      return std::unexpected(std::move(part.error()));
    }
  }
}

TransportResult<void> UsbTmcTransport::receivePart(const std::uint8_t* termChar, const Deadline& deadline) {
  const auto requested = m_options.requestSize;
  m_tag = usbtmc::nextTag(m_tag);
  if (auto asked = sendHeader(usbtmc::requestHeader(m_tag, requested, termChar), deadline); !asked) {
    m_stale = true;
    return asked;
  }
  // Room for header, data and what fills it to a multiple of 4, whole packets, and one packet more: the short or empty
  // packet that ends the transfer is then read with it and not with the next reply.
  const std::size_t packet = std::max<std::size_t>(1, m_channel.in.packetSize);
  const std::size_t room = usbtmc::headerSize + requested + usbtmc::alignment - 1;
  m_in.resize((room + packet - 1) / packet * packet + packet);
  const auto transfer = receiveTransfer(m_tag, deadline);
  if (!transfer) {
    return std::unexpected(transfer.error());
  }
  const auto received = checkedPart(*transfer, m_tag, requested);
  if (!received) {
    return received;
  }
  if (m_options.quirks.headerOnlyOnce) {
    const auto header = usbtmc::readHeader(*transfer);
    const auto block = blockSize(transfer->subspan(usbtmc::headerSize));
    return receiveRest(std::max<std::size_t>(header.size, block), deadline);
  }
  return {};
}

TransportResult<std::span<const std::uint8_t>> UsbTmcTransport::receiveTransfer(std::uint8_t tag,
                                                                                const Deadline& deadline) {
  auto received = m_pipe->bulkIn(m_channel.in.address, m_in, deadline.left());
  if (received) {
    return std::span<const std::uint8_t>(m_in).first(*received);
  }
  m_stale = true;
  switch (received.error().fault) {
  case UsbFault::TimedOut:
  case UsbFault::Cancelled:
    abortIn(tag);
    break;
  case UsbFault::Stalled:
    static_cast<void>(m_pipe->clearHalt(m_channel.in.address)); // the error to tell is the stall
    break;
  case UsbFault::Overflow:
    static_cast<void>(m_pipe->clearHalt(m_channel.in.address));
    abortIn(tag);
    break;
  default:
    break;
  }
  return failed(std::move(received.error()));
}

TransportResult<void> UsbTmcTransport::checkedPart(std::span<const std::uint8_t> transfer, std::uint8_t tag,
                                                   std::uint32_t requested) {
  if (transfer.size() < usbtmc::headerSize) {
    return damaged("a reply of " + std::to_string(transfer.size()) + " bytes is shorter than its header of " +
                       std::to_string(usbtmc::headerSize),
                   tag);
  }
  const auto header = usbtmc::readHeader(transfer);
  if (header.messageId != static_cast<std::uint8_t>(usbtmc::MessageId::RequestDeviceDependentIn)) {
    return damaged("the reply is of kind " + std::to_string(header.messageId) + " instead of 2", tag);
  }
  if (header.tag != tag || header.tagInverse != static_cast<std::uint8_t>(~tag & 0xFF)) {
    return damaged("the reply carries the tag " + std::to_string(header.tag) + "/" + std::to_string(header.tagInverse) +
                       " instead of " + std::to_string(tag) + "/" + std::to_string(~tag & 0xFF),
                   tag);
  }
  const auto data = transfer.subspan(usbtmc::headerSize);
  std::size_t size = header.size;
  if (!m_options.quirks.headerOnlyOnce) {
    if (size > requested) {
      return damaged("the reply announces " + std::to_string(size) + " bytes where " + std::to_string(requested) +
                         " were requested",
                     tag);
    }
    if (size > data.size()) {
      return damaged("the reply announces " + std::to_string(size) + " bytes and brings " + std::to_string(data.size()),
                     tag);
    }
  }
  size = std::min(size, data.size()); // what follows fills the packet
  m_ended = header.last || m_options.quirks.noEndOfMessage;
  if (size == 0 && !m_ended) {
    return damaged("the reply brings nothing and says that more follows", tag);
  }
  m_received.append(data.begin(), data.begin() + static_cast<std::ptrdiff_t>(size));
  return {};
}

TransportResult<void> UsbTmcTransport::receiveRest(std::size_t announced, const Deadline& deadline) {
  m_ended = true; // whatever the header said
  while (m_received.size() < announced) {
    const auto more = receiveTransfer(m_tag, deadline);
    if (!more) {
      return std::unexpected(more.error());
    }
    if (more->empty()) {
      return damaged("the reply announces " + std::to_string(announced) + " bytes and brings " +
                         std::to_string(m_received.size()),
                     m_tag);
    }
    m_received.append(more->begin(), more->end());
  }
  m_received.resize(announced);
  return {};
}

std::unexpected<TransportError> UsbTmcTransport::damaged(std::string what, std::uint8_t tag) {
  abortIn(tag); // the rest of it, if any
  m_stale = true;
  return std::unexpected(TransportError{TransportFault::Protocol,
                                        Error{ErrorKind::Instrument, std::move(what),
                                              "repeat the query; if it stays, report the recorded dialogue", m_name}});
}

std::unexpected<TransportError> UsbTmcTransport::misused(std::string what, std::string remedy) const {
  return std::unexpected(TransportError{TransportFault::Protocol,
                                        Error{ErrorKind::Instrument, std::move(what), std::move(remedy), m_name}});
}

std::unexpected<TransportError> UsbTmcTransport::failed(UsbError error) const {
  return std::unexpected(transportError(std::move(error), m_name));
}

void UsbTmcTransport::forgetReply() {
  m_received.clear();
  m_unansweredQuery.clear();
  m_replyDue = false;
  m_ended = false;
}

} // namespace straightedge::devices
