#include "tests/fakes/usb/emulated_device.h"

namespace straightedge::fakes {

std::optional<Bytes> EmulatedDevice::packetIn(std::uint8_t endpoint) {
  auto& queue = m_in[endpoint];
  if (queue.empty() || queue.front().ready > std::chrono::steady_clock::now()) {
    return std::nullopt;
  }
  auto packet = std::move(queue.front().bytes);
  queue.pop_front();
  return packet;
}

std::vector<std::string> EmulatedDevice::violations() const {
  const auto held = lock();
  return m_violations;
}

void EmulatedDevice::forgetViolations() {
  const auto held = lock();
  m_violations.clear();
}

int EmulatedDevice::resets() const {
  const auto held = lock();
  return m_resets;
}

int EmulatedDevice::haltsCleared(std::uint8_t endpoint) const {
  const auto held = lock();
  const auto it = m_haltsCleared.find(endpoint);
  return it == m_haltsCleared.end() ? 0 : it->second;
}

void EmulatedDevice::queueIn(std::uint8_t endpoint, const Bytes& bytes, bool ended, std::chrono::milliseconds after) {
  const std::size_t size = packetSize(endpoint);
  for (std::size_t from = 0; from < bytes.size(); from += size) {
    const std::size_t to = std::min(from + size, bytes.size());
    queuePacket(
        endpoint,
        Bytes(bytes.begin() + static_cast<std::ptrdiff_t>(from), bytes.begin() + static_cast<std::ptrdiff_t>(to)),
        after);
  }
  if (ended && bytes.size() % size == 0) {
    queuePacket(endpoint, {}, after);
  }
}

void EmulatedDevice::queuePacket(std::uint8_t endpoint, Bytes packet, std::chrono::milliseconds after) {
  m_in[endpoint].push_back({std::move(packet), std::chrono::steady_clock::now() + after});
}

bool EmulatedDevice::hasQueued(std::uint8_t endpoint) const {
  const auto it = m_in.find(endpoint);
  return it != m_in.end() && !it->second.empty();
}

Bytes configurationHeader(std::size_t interfaces, const Bytes& rest) {
  const std::size_t total = 9 + rest.size();
  Bytes bytes = {9,
                 2,
                 static_cast<std::uint8_t>(total & 0xFFU),
                 static_cast<std::uint8_t>(total >> 8U),
                 static_cast<std::uint8_t>(interfaces),
                 1,
                 0,
                 0x80,
                 50};
  append(bytes, rest);
  return bytes;
}

Bytes interfaceDescriptor(std::uint8_t number, std::uint8_t endpoints, std::uint8_t classCode, std::uint8_t subclass,
                          std::uint8_t protocol) {
  return {9, 4, number, 0, endpoints, classCode, subclass, protocol, 0};
}

Bytes endpointDescriptor(std::uint8_t address, std::uint8_t attributes, std::size_t packetSize) {
  return {7,
          5,
          address,
          attributes,
          static_cast<std::uint8_t>(packetSize & 0xFFU),
          static_cast<std::uint8_t>(packetSize >> 8U),
          static_cast<std::uint8_t>(attributes == 3 ? 1 : 0)};
}

void append(Bytes& to, const Bytes& more) { to.insert(to.end(), more.begin(), more.end()); }

Bytes bytesOf(std::string_view text) { return {text.begin(), text.end()}; }

std::string textOf(const Bytes& bytes) { return {bytes.begin(), bytes.end()}; }

} // namespace straightedge::fakes
