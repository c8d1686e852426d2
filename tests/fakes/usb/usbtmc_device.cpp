#include "tests/fakes/usb/usbtmc_device.h"

#include <algorithm>

namespace straightedge::fakes {

namespace {

constexpr std::uint8_t devDepMsgOut = 1;
constexpr std::uint8_t requestDevDepMsgIn = 2;
constexpr std::uint8_t trigger = 128;
constexpr std::size_t headerSize = 12;

std::uint32_t le32(const Bytes& bytes, std::size_t at) {
  return static_cast<std::uint32_t>(bytes[at]) | static_cast<std::uint32_t>(bytes[at + 1]) << 8U |
         static_cast<std::uint32_t>(bytes[at + 2]) << 16U | static_cast<std::uint32_t>(bytes[at + 3]) << 24U;
}

std::size_t padded(std::size_t size) { return (size + 3) / 4 * 4; }

Bytes headerIn(std::uint8_t tag, std::size_t size, bool last) {
  const auto part = [&](unsigned shift) { return static_cast<std::uint8_t>((size >> shift) & 0xFFU); };
  return {requestDevDepMsgIn, tag,      static_cast<std::uint8_t>(~tag & 0xFF),  0, part(0), part(8),
          part(16),           part(24), static_cast<std::uint8_t>(last ? 1 : 0), 0, 0,       0};
}

std::string withoutLineEnd(const Bytes& message) {
  auto text = textOf(message);
  while (text.ends_with('\n') || text.ends_with('\r')) {
    text.pop_back();
  }
  return text;
}

} // namespace

UsbTmcDevice::UsbTmcDevice(Options options) : EmulatedDevice(options.identity), m_options(std::move(options)) {}

void UsbTmcDevice::onMessage(Handler handler) {
  const auto held = lock();
  m_handler = std::move(handler);
}

void UsbTmcDevice::fault(UsbTmcFault fault) {
  const auto held = lock();
  m_fault = fault;
}

bool UsbTmcDevice::takeFault(UsbTmcFault fault) {
  if (m_fault != fault) {
    return false;
  }
  m_fault = UsbTmcFault::None;
  return true;
}

void UsbTmcDevice::requestService(std::uint8_t statusByte) {
  const auto held = lock();
  m_status = statusByte;
  queuePacket(interrupt, {0x81, statusByte});
}

void UsbTmcDevice::setStatusByte(std::uint8_t statusByte) {
  const auto held = lock();
  m_status = statusByte;
}

std::vector<std::string> UsbTmcDevice::messages() const {
  const auto held = lock();
  return m_messages;
}

std::vector<int> UsbTmcDevice::abortedTags() const {
  const auto held = lock();
  return m_abortedTags;
}

std::vector<int> UsbTmcDevice::abortedOutTags() const {
  const auto held = lock();
  return m_abortedOutTags;
}

int UsbTmcDevice::clears() const {
  const auto held = lock();
  return m_clears;
}

bool UsbTmcDevice::isRemote() const {
  const auto held = lock();
  return m_remote;
}

bool UsbTmcDevice::isFaultDue() const {
  const auto held = lock();
  return m_fault != UsbTmcFault::None;
}

int UsbTmcDevice::triggers() const {
  const auto held = lock();
  return m_triggers;
}

int UsbTmcDevice::requests() const {
  const auto held = lock();
  return m_requests;
}

Bytes UsbTmcDevice::configurationDescriptor() const {
  Bytes rest = interfaceDescriptor(0, m_options.interruptEndpoint ? 3 : 2, 0xFE, 3,
                                   static_cast<std::uint8_t>(m_options.interruptEndpoint ? 1 : 0));
  append(rest, endpointDescriptor(out, 2, m_options.packet));
  append(rest, endpointDescriptor(in, 2, m_options.packet));
  if (m_options.interruptEndpoint) {
    append(rest, endpointDescriptor(interrupt, 3, 2));
  }
  return configurationHeader(1, rest);
}

std::size_t UsbTmcDevice::packetSize(std::uint8_t endpoint) const {
  return endpoint == interrupt ? 2 : m_options.packet;
}

Handshake UsbTmcDevice::packetOut(std::uint8_t /*endpoint*/, const Bytes& packet) {
  if (m_neverTaking || takeFault(UsbTmcFault::NeverTakes)) {
    m_neverTaking = true;
    return Handshake::Nak;
  }
  if (takeFault(UsbTmcFault::StallOut)) {
    if (m_transfer.empty() && packet.size() >= headerSize) {
      m_lastTag = packet[1]; // used up all the same
    }
    m_transfer.clear();
    return Handshake::Stall;
  }
  if (takeFault(UsbTmcFault::UnplugOnMessage)) {
    unplugNow();
    return Handshake::Nak;
  }
  if (m_aborting || m_clearing) {
    violation("sent while an abort or a clear is not finished");
  }
  append(m_transfer, packet);
  const bool isMessage = m_transfer.size() >= headerSize && m_transfer[0] == devDepMsgOut;
  const std::size_t announced = isMessage ? headerSize + padded(le32(m_transfer, 4)) : headerSize;
  if (packet.size() < m_options.packet || m_transfer.size() >= announced) {
    transferArrived();
    m_transfer.clear();
  }
  return Handshake::Ack;
}

void UsbTmcDevice::checkHeader() {
  const std::uint8_t tag = m_transfer[1];
  const auto expected = static_cast<std::uint8_t>(m_lastTag ? *m_lastTag % 255 + 1 : tag);
  if (tag == 0) {
    violation("tag 0");
  } else if (tag != expected) {
    violation("tag " + std::to_string(tag) + " instead of " + std::to_string(expected));
  }
  if (m_transfer[2] != static_cast<std::uint8_t>(~tag & 0xFF)) {
    violation("tag without its inverse");
  }
  if (m_transfer[3] != 0) {
    violation("reserved byte not 0");
  }
  m_lastTag = tag;
}

void UsbTmcDevice::transferArrived() {
  if (m_transfer.size() < headerSize) {
    violation("a transfer shorter than its header");
    return;
  }
  checkHeader();
  const std::size_t size = le32(m_transfer, 4);
  switch (m_transfer[0]) {
  case devDepMsgOut:
    if (m_transfer.size() < headerSize + size) {
      violation("fewer bytes than announced");
      break;
    }
    if (m_transfer.size() != headerSize + padded(size)) {
      violation("not filled to a multiple of 4 bytes");
    }
    messageArrived(m_transfer, size, (m_transfer[8] & 1U) != 0);
    break;
  case requestDevDepMsgIn:
    if (m_transfer.size() != headerSize) {
      violation("a request of " + std::to_string(m_transfer.size()) + " bytes");
    }
    requestArrived(m_transfer);
    break;
  case trigger:
    ++m_triggers;
    break;
  default:
    violation("unknown message " + std::to_string(m_transfer[0]));
  }
}

void UsbTmcDevice::messageArrived(const Bytes& transfer, std::size_t size, bool last) {
  if (m_replyDue || m_reading) {
    violation("a message while a reply waits (INTERRUPTED)");
    dropAll();
  }
  const auto from = transfer.begin() + static_cast<std::ptrdiff_t>(headerSize);
  m_message.insert(m_message.end(), from, from + static_cast<std::ptrdiff_t>(size));
  if (!last) {
    return;
  }
  const auto text = withoutLineEnd(m_message);
  m_message.clear();
  m_messages.push_back(text);
  if (const auto reply = m_handler ? m_handler(text) : std::nullopt) {
    m_reply = bytesOf(*reply);
    if (m_options.endsLines) {
      m_reply.push_back('\n');
    }
    m_replyDue = true;
  }
}

void UsbTmcDevice::requestArrived(const Bytes& transfer) {
  ++m_requests;
  const std::size_t requested = le32(transfer, 4);
  if (m_reading) {
    violation("a request while another one is under way");
  }
  m_reading = true;
  m_readTag = transfer[1];
  if (requested == 0) {
    violation("a request of 0 bytes");
  }
  if (!m_replyDue) {
    violation("a request without a query (UNTERMINATED)");
    return; // never answered, as real instruments do
  }
  const bool hasTermChar = (transfer[8] & 2U) != 0;
  if (hasTermChar && !m_options.termChar) {
    violation("a termination character, which the device does not know");
  }
  sendReply(requested, hasTermChar && m_options.termChar ? std::optional(transfer[9]) : std::nullopt);
}

void UsbTmcDevice::sendReply(std::size_t requested, std::optional<std::uint8_t> termChar) {
  if (m_fault == UsbTmcFault::AbortStaysPending) {
    m_fault = UsbTmcFault::None;
    m_pendingAnswers = 3;
    return;
  }
  if (takeFault(UsbTmcFault::NeverAnswers)) {
    return;
  }
  if (takeFault(UsbTmcFault::StallIn)) {
    halt(in);
    m_reading = false;
    m_replyDue = false;
    m_reply.clear();
    return;
  }
  std::size_t size = std::min(requested, m_reply.size());
  if (m_options.largestTransfer > 0) {
    size = std::min(size, m_options.largestTransfer);
  }
  if (termChar) {
    const auto it = std::ranges::find(m_reply, *termChar);
    size = std::min(size, static_cast<std::size_t>(it - m_reply.begin()) + (it == m_reply.end() ? 0U : 1U));
  }
  if (m_options.headerOnlyOnce) {
    auto first = headerIn(m_readTag, m_reply.size(), true);
    append(first, Bytes(m_reply.begin(), m_reply.begin() + static_cast<std::ptrdiff_t>(size)));
    queueIn(in, first);
    for (std::size_t from = size; from < m_reply.size(); from += size) {
      const auto to = std::min(from + size, m_reply.size());
      queueIn(in, Bytes(m_reply.begin() + static_cast<std::ptrdiff_t>(from),
                        m_reply.begin() + static_cast<std::ptrdiff_t>(to)));
    }
    m_reply.clear();
    m_replyDue = false;
    return;
  }
  const auto end = m_reply.begin() + static_cast<std::ptrdiff_t>(size);
  Bytes part(m_reply.begin(), end);
  m_reply.erase(m_reply.begin(), end);
  m_replyDue = !m_reply.empty();
  if (m_fault != UsbTmcFault::None) {
    sendFaulty(std::move(part), requested);
    return;
  }
  auto all = headerIn(m_readTag, part.size(), !m_replyDue);
  append(all, part);
  if (m_options.padsReplies) {
    all.resize(padded(all.size()));
  }
  queueIn(in, all);
}

void UsbTmcDevice::sendFaulty(Bytes reply, std::size_t requested) {
  const auto fault = m_fault;
  auto after = std::chrono::milliseconds(0);
  auto header = headerIn(m_readTag, reply.size(), !m_replyDue);
  switch (fault) {
  case UsbTmcFault::Delay:
    after = m_options.delay;
    break;
  case UsbTmcFault::ShortHeader:
    header.resize(5);
    reply.clear();
    break;
  case UsbTmcFault::WrongTag:
    header[1] = static_cast<std::uint8_t>(header[1] % 255 + 1);
    header[2] = static_cast<std::uint8_t>(~header[1] & 0xFF);
    break;
  case UsbTmcFault::WrongTagAlone:
    header[1] = static_cast<std::uint8_t>(header[1] % 255 + 1);
    break;
  case UsbTmcFault::WrongInverse:
    header[2] = header[1];
    break;
  case UsbTmcFault::WrongMessageId:
    header[0] = 127;
    break;
  case UsbTmcFault::Babble:
    m_fault = UsbTmcFault::None;
    m_replyDue = false;
    m_reply.clear();
    append(header, Bytes(m_options.packet, 'x'));
    queuePacket(in, header);
    m_reading = false;
    return;
  case UsbTmcFault::Truncated:
    header = headerIn(m_readTag, reply.size() + 10, true);
    break;
  case UsbTmcFault::ExtraBytes:
    append(reply, bytesOf("extra"));
    break;
  case UsbTmcFault::SizeBeyondRequest:
    reply.resize(requested + 4, 'y');
    header = headerIn(m_readTag, reply.size(), true);
    break;
  case UsbTmcFault::SizeHuge:
    header = headerIn(m_readTag, 0xFFFFFFF0U, true);
    break;
  case UsbTmcFault::EmptyReply:
    m_reply = reply;
    m_replyDue = true;
    reply.clear();
    header = headerIn(m_readTag, 0, false);
    break;
  case UsbTmcFault::UnplugOnRequest:
    unplugNow();
    return;
  case UsbTmcFault::UnplugMidReply:
    m_leaveMidReply = true;
    break;
  default:
    auto all = header;
    append(all, reply);
    queueIn(in, all);
    return; // a fault of another moment: stays armed
  }
  m_fault = UsbTmcFault::None;
  auto all = header;
  append(all, reply);
  queueIn(in, all, true, after);
}

std::optional<Bytes> UsbTmcDevice::packetIn(std::uint8_t endpoint) {
  auto packet = EmulatedDevice::packetIn(endpoint);
  if (endpoint == in && packet) {
    if (packet->size() < m_options.packet) {
      m_reading = false;
    }
    if (m_leaveMidReply) {
      m_leaveMidReply = false;
      unplugNow();
      dropQueued(in);
    }
  }
  return packet;
}

void UsbTmcDevice::haltCleared(std::uint8_t endpoint) {
  EmulatedDevice::haltCleared(endpoint);
  if (endpoint == in) {
    dropQueued(in);
  }
}

void UsbTmcDevice::dropAll() {
  dropQueued(in);
  m_transfer.clear();
  m_message.clear();
  m_reply.clear();
  m_replyDue = false;
  m_reading = false;
}

void UsbTmcDevice::wasClaimed() { m_lastTag.reset(); }

void UsbTmcDevice::wasReset() {
  m_lastTag.reset();
  EmulatedDevice::wasReset();
  dropAll();
  m_neverTaking = false;
  m_aborting = false;
  m_clearing = false;
}

} // namespace straightedge::fakes
