#include "tests/fakes/usb/byte_stream_devices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace straightedge::fakes {

void ByteStreamDevice::onBytes(Handler handler) {
  const auto held = lock();
  m_handler = std::move(handler);
}

void ByteStreamDevice::onLine(std::string end, Handler handler) {
  onBytes(
      [end = std::move(end), handler = std::move(handler), pending = std::string()](const std::string& bytes) mutable {
        pending += bytes;
        std::string answers;
        for (auto at = pending.find(end); at != std::string::npos; at = pending.find(end)) {
          const auto line = pending.substr(0, at);
          pending.erase(0, at + end.size());
          answers += handler(line);
        }
        return answers;
      });
}

void ByteStreamDevice::generate(Generator generator) {
  const auto held = lock();
  m_generator = std::move(generator);
}

void ByteStreamDevice::onLineState(LineWatcher watcher) {
  const auto held = lock();
  m_watcher = std::move(watcher);
}

void ByteStreamDevice::push(std::string_view bytes) {
  const auto held = lock();
  m_toHost += bytes;
}

void ByteStreamDevice::stallNextRead() {
  const auto held = lock();
  m_stallRead = true;
}

void ByteStreamDevice::stallNextWrite() {
  const auto held = lock();
  m_stallWrite = true;
}

void ByteStreamDevice::holdWrites(bool hold) {
  const auto held = lock();
  m_hold = hold;
}

void ByteStreamDevice::unplugAfter(std::size_t bytes) {
  const auto held = lock();
  m_leaveAfter = bytes;
}

std::string ByteStreamDevice::received() const {
  const auto held = lock();
  return m_received;
}

LineState ByteStreamDevice::line() const {
  const auto held = lock();
  return m_line;
}

void ByteStreamDevice::setLine(const LineState& line) {
  const auto before = m_line;
  m_line = line;
  if (m_watcher) {
    m_toHost += m_watcher(before, line);
  }
}

Handshake ByteStreamDevice::takeBytes(std::uint8_t /*endpoint*/, const Bytes& packet) {
  if (m_hold) {
    return Handshake::Nak;
  }
  if (std::exchange(m_stallWrite, false)) {
    return Handshake::Stall;
  }
  const auto text = textOf(packet);
  m_received += text;
  if (m_handler) {
    m_toHost += m_handler(text);
  }
  return Handshake::Ack;
}

std::string ByteStreamDevice::giveBytes(std::uint8_t endpoint, std::size_t most) {
  if (std::exchange(m_stallRead, false)) {
    halt(endpoint);
    return {};
  }
  if (m_generator) {
    m_toHost += m_generator();
  }
  std::size_t count = std::min(most, m_toHost.size() - m_given);
  if (m_leaveAfter) {
    count = std::min(count, *m_leaveAfter);
    *m_leaveAfter -= count;
    if (*m_leaveAfter == 0) {
      m_leaveAfter.reset();
      unplugNow();
    }
  }
  auto bytes = m_toHost.substr(m_given, count);
  m_given += count;
  if (m_given == m_toHost.size() || m_given > 65536) { // now and then: a stream that waits may be long
    m_toHost.erase(0, m_given);
    m_given = 0;
  }
  return bytes;
}

Bytes CdcAcmDevice::configurationDescriptor() const {
  Bytes rest = interfaceDescriptor(0, 1, 0x02, 0x02, 0x01);
  append(rest, {5, 0x24, 0x00, 0x10, 0x01}); // header
  append(rest, {5, 0x24, 0x01, 0x00, 0x01}); // call management: data interface 1
  append(rest, {4, 0x24, 0x02, 0x02});       // abstract control: line coding and state
  append(rest, {5, 0x24, 0x06, 0x00, 0x01}); // union
  append(rest, endpointDescriptor(notify, 3, 8));
  append(rest, interfaceDescriptor(1, 2, 0x0A, 0, 0));
  append(rest, endpointDescriptor(out, 2, 64));
  append(rest, endpointDescriptor(in, 2, 64));
  return configurationHeader(2, rest);
}

std::optional<Bytes> CdcAcmDevice::control(const ControlSetup& setup, const Bytes& data) {
  auto state = line();
  if (setup.requestType == 0x21 && setup.request == 0x20 && data.size() == 7) { // SET_LINE_CODING
    state.baud = data[0] | data[1] << 8 | data[2] << 16 | data[3] << 24;
    state.stopBits = data[4] == 0 ? 1 : 2;
    state.parity = data[5] == 0 ? 'N' : (data[5] == 1 ? 'O' : 'E');
    state.dataBits = data[6];
    setLine(state);
    return Bytes();
  }
  if (setup.requestType == 0x21 && setup.request == 0x22) { // SET_CONTROL_LINE_STATE
    state.dtr = (setup.value & 1U) != 0;
    state.rts = (setup.value & 2U) != 0;
    setLine(state);
    return Bytes();
  }
  return std::nullopt;
}

std::optional<Bytes> CdcAcmDevice::packetIn(std::uint8_t endpoint) {
  if (endpoint != in) {
    return EmulatedDevice::packetIn(endpoint);
  }
  const auto bytes = giveBytes(in, packetSize(in));
  if (bytes.empty()) { // a full packet and nothing after it: boards end the transfer
    return std::exchange(m_endWithEmpty, false) ? std::optional<Bytes>(Bytes()) : std::nullopt;
  }
  m_endWithEmpty = bytes.size() == packetSize(in);
  return bytesOf(bytes);
}

void FtdiDevice::setLineErrors(std::uint8_t bits) {
  const auto held = lock();
  m_errors = bits;
}

int FtdiDevice::latencyMs() const {
  const auto held = lock();
  return m_latencyMs;
}

int FtdiDevice::resetsOfChip() const {
  const auto held = lock();
  return m_chipResets;
}

int FtdiDevice::purges() const {
  const auto held = lock();
  return m_purges;
}

Bytes FtdiDevice::configurationDescriptor() const {
  Bytes rest = interfaceDescriptor(0, 2, 0xFF, 0xFF, 0xFF);
  append(rest, endpointDescriptor(in, 2, 64));
  append(rest, endpointDescriptor(out, 2, 64));
  return configurationHeader(1, rest);
}

std::optional<Bytes> FtdiDevice::control(const ControlSetup& setup, const Bytes& /*data*/) {
  if (setup.requestType != 0x40) {
    return std::nullopt;
  }
  auto state = line();
  switch (setup.request) {
  case 0: // SIO_RESET and purges
    if (setup.value == 0) {
      ++m_chipResets;
    } else {
      ++m_purges;
    }
    if (setup.value != 2) {
      dropToHost();
    }
    return Bytes();
  case 1: // modem control: high byte says which lines
    if ((setup.value & 0x100U) != 0) {
      state.dtr = (setup.value & 1U) != 0;
    }
    if ((setup.value & 0x200U) != 0) {
      state.rts = (setup.value & 2U) != 0;
    }
    setLine(state);
    return Bytes();
  case 2: // flow control: in the index's high byte
    state.flow = (setup.index & 0x100U) != 0 ? 'R' : ((setup.index & 0x400U) != 0 ? 'X' : 'N');
    setLine(state);
    return Bytes();
  case 3: { // 3 MHz over a divisor of 14 bits and an eighth in three more; 0 and 1 are special
    const unsigned divisor = setup.value & 0x3FFFU;
    const unsigned code = (setup.value >> 14U) | ((setup.index & 1U) << 2U);
    constexpr std::array<unsigned, 8> eighths = {0, 4, 2, 1, 3, 5, 6, 7};
    const double eighth = divisor * 8 + eighths.at(code);
    state.baud = divisor == 0   ? 3'000'000
                 : divisor == 1 ? 2'000'000
                                : static_cast<int>(std::lround(3'000'000.0 * 8 / eighth));
    setLine(state);
    return Bytes();
  }
  case 4: { // data bits, parity, stop bits
    constexpr std::array<char, 3> parities = {'N', 'O', 'E'};
    state.dataBits = setup.value & 0xFF;
    state.parity = parities.at((setup.value >> 8U) & 3U);
    state.stopBits = (setup.value >> 11U) & 3U ? 2 : 1;
    setLine(state);
    return Bytes();
  }
  case 9:
    m_latencyMs = setup.value;
    return Bytes();
  default:
    return std::nullopt;
  }
}

std::optional<Bytes> FtdiDevice::packetIn(std::uint8_t endpoint) {
  const auto now = std::chrono::steady_clock::now();
  const auto bytes = giveBytes(endpoint, 62);
  if (bytes.empty() && now - m_lastPacket < std::chrono::milliseconds(m_latencyMs)) {
    return std::nullopt;
  }
  m_lastPacket = now;
  Bytes packet = {0x01, static_cast<std::uint8_t>(0x60U | std::exchange(m_errors, std::uint8_t{0}))};
  append(packet, bytesOf(bytes));
  return packet;
}

} // namespace straightedge::fakes
