// USBTMC 1.0 and USB488 1.0 on the wire: headers of 12 bytes, numbers of requests, status values. The texts of the
// standards are free at usb.org; the points that hosts get wrong have their tests in tests/devices/usb.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace straightedge::devices::usbtmc {

inline constexpr std::uint8_t interfaceClass = 0xFE;
inline constexpr std::uint8_t interfaceSubclass = 0x03;
inline constexpr std::uint8_t protocolUsb488 = 0x01;

inline constexpr std::size_t headerSize = 12;
inline constexpr std::size_t alignment = 4;

enum class MessageId : std::uint8_t { DeviceDependentOut = 1, RequestDeviceDependentIn = 2, Trigger = 128 };

enum class Request : std::uint8_t {
  InitiateAbortBulkOut = 1,
  CheckAbortBulkOutStatus = 2,
  InitiateAbortBulkIn = 3,
  CheckAbortBulkInStatus = 4,
  InitiateClear = 5,
  CheckClearStatus = 6,
  GetCapabilities = 7,
  ReadStatusByte = 128,
  RemoteControl = 160,
  GoToLocal = 161,
};

inline constexpr std::uint8_t toInterface = 0xA1; ///< bmRequestType: class, interface, the device answers
inline constexpr std::uint8_t toEndpoint = 0xA2;  ///< bmRequestType: class, endpoint, the device answers

inline constexpr std::uint8_t statusSuccess = 0x01;
inline constexpr std::uint8_t statusPending = 0x02;

inline constexpr std::uint8_t serviceRequest =
    0x81; ///< first byte of such a notification; 0x80 | tag answers a status read

using Header = std::array<std::uint8_t, headerSize>;

/// Of a message of `size` bytes; `last`: the message ends with it.
Header messageHeader(std::uint8_t tag, std::uint32_t size, bool last);

/// Asks for up to `size` bytes of the reply, up to `termChar` if one is given (only where the device knows it).
Header requestHeader(std::uint8_t tag, std::uint32_t size, const std::uint8_t* termChar);

Header triggerHeader(std::uint8_t tag);

/// 1 … 255, then 1 again: 0 is no tag.
constexpr std::uint8_t nextTag(std::uint8_t tag) { return static_cast<std::uint8_t>(tag == 255 ? 1 : tag + 1); }

constexpr std::size_t paddedSize(std::size_t size) { return (size + alignment - 1) / alignment * alignment; }

struct ReplyHeader {
  std::uint8_t messageId = 0;
  std::uint8_t tag = 0;
  std::uint8_t tagInverse = 0;
  std::uint32_t size = 0;
  bool last = false;
};

/// `bytes` hold at least a header.
ReplyHeader readHeader(std::span<const std::uint8_t> bytes);

/// What GET_CAPABILITIES says; without an answer nothing is assumed.
struct Capabilities {
  bool termChar = false;
  bool remoteControl = false;
  bool trigger = false;
};

Capabilities readCapabilities(std::span<const std::uint8_t> bytes);

} // namespace straightedge::devices::usbtmc
