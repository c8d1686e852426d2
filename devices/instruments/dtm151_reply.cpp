#include "devices/instruments/dtm151_reply.h"

#include "core/base/number_text.h"
#include "devices/instruments/conversation.h"

#include <array>
#include <cmath>

namespace straightedge::devices {

namespace {

/// Longer ones before those that they contain.
constexpr std::array<std::string_view, 15> errorTexts = {"INVALID COMMAND ENTRY",
                                                         "NUMBER TOO BIG",
                                                         "POSITIVE NUMBER REQUIRED",
                                                         "DIVIDE BY ZERO",
                                                         "NO TEMPERATURE PROBE",
                                                         "BAD TEMPERATURE READING",
                                                         "FRAMING ERROR",
                                                         "OVERRUN ERROR",
                                                         "PARITY ERROR",
                                                         "DATA CARRIER NOT PRESENT",
                                                         "FIXED RANGE PROBE",
                                                         "NO PROBE",
                                                         "OVER RANGE",
                                                         "OVERFLOW",
                                                         "RESET"};

} // namespace

std::expected<Dtm151Number, std::string> parseDtm151Number(std::string_view text) {
  text = withoutBlanks(text);
  for (const std::string_view error : errorTexts) {
    if (text.find(error) != std::string_view::npos) {
      return std::unexpected(std::string(error));
    }
  }
  Dtm151Number number;
  for (const std::string_view unit : {"kG", "T", "G", "C"}) {
    if (text.ends_with(unit)) {
      number.unit = unit;
      text.remove_suffix(unit.size());
      break;
    }
  }
  const auto value = parseDouble(text);
  if (!value || !std::isfinite(*value)) {
    return std::unexpected(std::string());
  }
  number.value = *value;
  return number;
}

} // namespace straightedge::devices
