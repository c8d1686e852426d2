#include "devices/instruments/thm1176_reply.h"

#include "core/base/number_text.h"
#include "devices/instruments/conversation.h"
#include "devices/instruments/scpi_replies.h"

#include <charconv>
#include <cmath>

namespace straightedge::devices {

namespace {

std::optional<double> tesla(std::string_view text) {
  text = withoutBlanks(text);
  double scale = 0.0;
  if (text.ends_with("MT") || text.ends_with("mT")) {
    scale = 1e-3;
    text.remove_suffix(2);
  } else if (text.ends_with('T')) {
    scale = 1.0;
    text.remove_suffix(1);
  } else {
    return std::nullopt; // gauss, MHz or nothing: the unit was set to tesla
  }
  const auto value = parseScpiNumber(text);
  return value ? std::optional(*value * scale) : std::nullopt;
}

std::optional<std::uint64_t> stamp(std::string_view text) {
  text = withoutBlanks(text);
  if (!text.starts_with("0x") && !text.starts_with("0X")) {
    return std::nullopt;
  }
  std::uint64_t value = 0;
  const auto [end, status] = std::from_chars(text.data() + 2, text.data() + text.size(), value, 16);
  return status == std::errc{} && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

} // namespace

std::optional<Thm1176Reply> parseThm1176Reply(std::string_view text) {
  std::array<std::string_view, 6> fields{};
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::size_t semicolon = text.find(';');
    if ((semicolon == std::string_view::npos) != (i + 1 == fields.size())) {
      return std::nullopt;
    }
    fields[i] = text.substr(0, semicolon);
    text.remove_prefix(semicolon == std::string_view::npos ? text.size() : semicolon + 1);
  }
  Thm1176Reply reply;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto value = tesla(fields[axis]);
    if (!value) {
      return std::nullopt;
    }
    reply.fieldT[axis] = *value;
    reply.overload = reply.overload || std::abs(*value) >= 9.9e34; // 9.9e37 in mT, too
  }
  const auto stampNs = stamp(fields[3]);
  const auto temperature = parseInt(fields[4]);
  const auto status = parseInt(fields[5]);
  if (!stampNs || !temperature || !status || *status < 0 || *status > 255) {
    return std::nullopt;
  }
  reply.stampNs = *stampNs;
  reply.temperature = *temperature;
  reply.status = *status;
  return reply;
}

} // namespace straightedge::devices
