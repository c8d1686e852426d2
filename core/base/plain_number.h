// Plain numbers from text, quickly: what nearly every cell of a measured table holds. Everything else (exponents,
// blanks, nan, twenty digits) is for parseDouble(), which begins with this.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace straightedge {

/// The number that the text begins with: an optional minus, digits, and perhaps `point` with further digits. Gives the
/// place after it; nullptr where the text begins otherwise or the number has too many digits to be exact here.
/// Exactly what std::from_chars() gives: up to 2^53 the digits are an exact double, as are the powers of ten up to
/// 10^22, and one division rounds correctly (W. D. Clinger, How to read floating point numbers accurately, 1990).
inline const char* readPlainNumber(const char* at, const char* end, char point, double& value) {
  constexpr std::array<double, 20> powersOfTen = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,
                                                  1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19};
  constexpr std::ptrdiff_t mostDigits = 19; // fewer than 2^64 whatever they are
  constexpr std::uint64_t mostExact = std::uint64_t{1} << 53U;
  const bool negative = at != end && *at == '-';
  at += negative ? 1 : 0;
  std::uint64_t digits = 0;
  const auto takeDigits = [&] {
    const char* const begin = at;
    for (; at != end; ++at) {
      const auto digit = static_cast<unsigned char>(static_cast<unsigned char>(*at) - static_cast<unsigned char>('0'));
      if (digit > 9U) {
        break;
      }
      digits = 10U * digits + digit;
    }
    return at - begin;
  };
  const std::ptrdiff_t before = takeDigits();
  std::ptrdiff_t after = 0;
  if (before > 0 && at != end && *at == point) {
    ++at;
    after = takeDigits();
    if (after == 0) {
      return nullptr;
    }
  }
  if (before == 0 || before + after > mostDigits || digits > mostExact) {
    return nullptr;
  }
  const double magnitude = static_cast<double>(digits) / powersOfTen[static_cast<std::size_t>(after)];
  value = negative ? -magnitude : magnitude;
  return at;
}

} // namespace straightedge
