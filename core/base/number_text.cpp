#include "core/base/number_text.h"

#include "core/base/plain_number.h"

#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

namespace straightedge {

namespace {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view whiteSpace = " \t\r\n";
  const auto first = text.find_first_not_of(whiteSpace);
  if (first == std::string_view::npos) {
    return {};
  }
  return text.substr(first, text.find_last_not_of(whiteSpace) - first + 1);
}

std::string_view withoutPlus(std::string_view text) {
  if (text.size() > 1 && text.front() == '+' && text[1] != '-' && text[1] != '+') {
    text.remove_prefix(1);
  }
  return text;
}

} // namespace

std::string formatDouble(double value) {
  std::array<char, longestDoubleText> buffer{};
  return {buffer.data(), formatDouble(value, buffer.data())};
}

char* formatDouble(double value, char* out) { return std::to_chars(out, out + longestDoubleText, value).ptr; }

std::string formatForPeople(double value, int digits) {
  std::array<char, 64> buffer{};
  const double magnitude = std::abs(value);
  const bool plain = value == 0.0 || (magnitude >= 1e-4 && magnitude < 1e6);
  if (!plain || !std::isfinite(value)) {
    const auto end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, digits);
    return {buffer.data(), end.ptr};
  }
  const int integerDigits = value == 0.0 ? 1 : static_cast<int>(std::floor(std::log10(magnitude))) + 1;
  const int decimals = digits > integerDigits ? digits - integerDigits : 0;
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
  return {buffer.data(), end.ptr};
}

std::optional<double> parseDouble(std::string_view text, char decimalPoint) {
  const char* const textEnd = text.data() + text.size();
  double plain = 0.0;
  if (!text.empty() && readPlainNumber(text.data(), textEnd, decimalPoint, plain) == textEnd) {
    return plain;
  }
  text = withoutPlus(trimmed(text));
  std::string replaced;
  if (decimalPoint != '.') {
    if (text.find('.') != std::string_view::npos) {
      return std::nullopt;
    }
    replaced = text;
    for (char& c : replaced) {
      if (c == decimalPoint) {
        c = '.';
      }
    }
    text = replaced;
  }
  double value = 0.0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc{} || end != text.data() + text.size() || text.empty()) {
    return std::nullopt;
  }
  return value;
}

std::optional<int> parseInt(std::string_view text) {
  text = withoutPlus(trimmed(text));
  int value = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc{} || end != text.data() + text.size() || text.empty()) {
    return std::nullopt;
  }
  return value;
}

} // namespace straightedge
