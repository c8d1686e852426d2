#include "devices/transport/usbtmc_wire.h"

namespace straightedge::devices::usbtmc {

namespace {

Header header(MessageId id, std::uint8_t tag, std::uint32_t size) {
  const auto byte = [size](unsigned shift) { return static_cast<std::uint8_t>((size >> shift) & 0xFFU); };
  return {static_cast<std::uint8_t>(id),
          tag,
          static_cast<std::uint8_t>(~tag & 0xFF),
          0,
          byte(0),
          byte(8),
          byte(16),
          byte(24),
          0,
          0,
          0,
          0};
}

} // namespace

Header messageHeader(std::uint8_t tag, std::uint32_t size, bool last) {
  auto bytes = header(MessageId::DeviceDependentOut, tag, size);
  bytes[8] = last ? 1 : 0;
  return bytes;
}

Header requestHeader(std::uint8_t tag, std::uint32_t size, const std::uint8_t* termChar) {
  auto bytes = header(MessageId::RequestDeviceDependentIn, tag, size);
  if (termChar != nullptr) {
    bytes[8] = 2;
    bytes[9] = *termChar;
  }
  return bytes;
}

Header triggerHeader(std::uint8_t tag) { return header(MessageId::Trigger, tag, 0); }

ReplyHeader readHeader(std::span<const std::uint8_t> bytes) {
  return {.messageId = bytes[0],
          .tag = bytes[1],
          .tagInverse = bytes[2],
          .size = static_cast<std::uint32_t>(bytes[4]) | static_cast<std::uint32_t>(bytes[5]) << 8U |
                  static_cast<std::uint32_t>(bytes[6]) << 16U | static_cast<std::uint32_t>(bytes[7]) << 24U,
          .last = (bytes[8] & 1U) != 0};
}

Capabilities readCapabilities(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < 16 || bytes[0] != statusSuccess) {
    return {};
  }
  return {.termChar = (bytes[5] & 1U) != 0, .remoteControl = (bytes[14] & 2U) != 0, .trigger = (bytes[14] & 1U) != 0};
}

} // namespace straightedge::devices::usbtmc
