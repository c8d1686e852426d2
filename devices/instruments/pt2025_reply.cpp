#include "devices/instruments/pt2025_reply.h"

#include "core/base/number_text.h"
#include "devices/instruments/conversation.h"

#include <charconv>
#include <cmath>

namespace straightedge::devices {

std::optional<Pt2025Reading> parsePt2025Reading(std::string_view text) {
  text = withoutBlanks(text);
  if (text.size() < 3) {
    return std::nullopt;
  }
  Pt2025Reading reading;
  switch (text.front()) {
  case 'L':
    reading.state = NmrState::Locked;
    break;
  case 'S':
    reading.state = NmrState::Signal;
    break;
  case 'N':
    reading.state = NmrState::NoSignal;
    break;
  case 'W':
    reading.state = NmrState::Wrong;
    break;
  default:
    return std::nullopt;
  }
  if (text.back() != 'T' && text.back() != 'F') {
    return std::nullopt;
  }
  reading.tesla = text.back() == 'T';
  const std::string_view digits = text.substr(1, text.size() - 2);
  // Digits and a point only: "S03F" is a status of 12 bits and no field of 3 MHz.
  if (digits.find_first_not_of("0123456789.") != std::string_view::npos || digits.find('.') == std::string_view::npos) {
    return std::nullopt;
  }
  const auto value = parseDouble(digits);
  if (!value || !std::isfinite(*value)) {
    return std::nullopt;
  }
  reading.value = *value;
  return reading;
}

std::optional<unsigned> parsePt2025Status(std::string_view text) {
  text = withoutBlanks(text);
  if (text.size() < 3 || text.size() > 4 || text.front() != 'S') {
    return std::nullopt;
  }
  unsigned bits = 0;
  const auto [end, status] = std::from_chars(text.data() + 1, text.data() + text.size(), bits, 16);
  return status == std::errc{} && end == text.data() + text.size() ? std::optional(bits) : std::nullopt;
}

} // namespace straightedge::devices
