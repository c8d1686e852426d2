#include "devices/instruments/qsb_reply.h"

#include <array>
#include <charconv>

namespace straightedge::devices {

namespace {

std::optional<std::uint32_t> hex(std::string_view digits) {
  std::uint32_t value = 0;
  const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  if (status != std::errc{} || end != digits.data() + digits.size()) {
    return std::nullopt;
  }
  return value;
}

} // namespace

std::optional<QsbReply> parseQsbReply(std::string_view text) {
  // Kind, 2 digits of register, 8 of data, perhaps 8 of stamp, '!'; blanks and line ends say nothing.
  std::array<char, 20> packed{};
  std::size_t size = 0;
  for (const char c : text) {
    if (c == ' ' || c == '\r' || c == '\n') {
      continue;
    }
    if (size == packed.size()) {
      return std::nullopt;
    }
    packed[size++] = c;
  }
  const std::string_view all(packed.data(), size);
  if ((size != 12 && size != 20) || all.back() != '!' ||
      std::string_view("rwsex").find(all[0]) == std::string_view::npos) {
    return std::nullopt;
  }
  const auto reg = hex(all.substr(1, 2));
  const auto data = hex(all.substr(3, 8));
  const auto stamp = size == 20 ? hex(all.substr(11, 8)) : std::nullopt;
  if (!reg || !data || (size == 20 && !stamp)) {
    return std::nullopt;
  }
  return QsbReply{all[0], static_cast<std::uint8_t>(*reg), *data, stamp};
}

} // namespace straightedge::devices
