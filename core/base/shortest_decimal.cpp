#include "core/base/shortest_decimal.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace straightedge {

#if defined(__SIZEOF_INT128__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__

namespace {

__extension__ typedef unsigned __int128 Wide;

constexpr int mostPower = 38; ///< the last power of ten that has at most 128 bits

/// 10^n with its leading one moved to the top: exact.
struct PowerOfTen {
  std::uint64_t high = 0, low = 0;
  int bits = 0; ///< of 10^n itself
};

constexpr std::array<PowerOfTen, mostPower + 1> makePowersOfTen() {
  std::array<PowerOfTen, mostPower + 1> powers;
  Wide power = 1;
  for (PowerOfTen& entry : powers) {
    const auto upper = static_cast<std::uint64_t>(power >> 64U);
    entry.bits =
        static_cast<int>(upper != 0 ? 64U + std::bit_width(upper) : std::bit_width(static_cast<std::uint64_t>(power)));
    const Wide moved = power << static_cast<unsigned>(128 - entry.bits);
    entry.high = static_cast<std::uint64_t>(moved >> 64U);
    entry.low = static_cast<std::uint64_t>(moved);
    power *= 10U; // after the last one it overflows, and is not used
  }
  return powers;
}
constexpr auto powersOfTen = makePowersOfTen();

/// floor(factor · power / 2^128), the last bit set too where something is cut off: comparing it with an even number
/// tells less, equal or more of the exact product.
std::uint64_t scaled(const PowerOfTen& power, std::uint64_t factor) {
  const Wide low = Wide{power.low} * factor;
  const Wide high = Wide{power.high} * factor + (low >> 64U);
  const bool cutOff = (static_cast<std::uint64_t>(high) | static_cast<std::uint64_t>(low)) != 0;
  return static_cast<std::uint64_t>(high >> 64U) | (cutOff ? 1U : 0U);
}

/// digits · 10^exponent
struct Decimal {
  std::uint64_t digits = 0; ///< 16 or 17 of them, zeros at the end as they come
  int exponent = 0;
};

/// The shortest decimal between the midpoints to the neighbours of significand · 2^exponent, the closest of several;
/// the significand has all its bits and is no power of two. After R. Giulietti, The Schubfach way to render doubles
/// (2020): in units of 10^exponent the interval is longer than 1 and shorter than 10, so that a multiple of ten is the
/// shortest if one lies inside, and otherwise the nearest whole number is. As his power of ten fits into 128 bits here,
/// the products are exact, and as the interval is symmetric, the nearest candidate is inside if any is.
Decimal shortestOf(std::uint64_t significand, int exponent) {
  const int decade = (exponent * 1262611) >> 22; // floor of exponent · log10(2)
  const PowerOfTen& power = powersOfTen[static_cast<std::size_t>(-decade)];
  const auto shift = static_cast<unsigned>(exponent + power.bits); // 1 to 4
  const std::uint64_t excluded = significand & 1U;                 // midpoints round to the even neighbour
  // Four times what is meant, so that a half is a whole number.
  const std::uint64_t value = scaled(power, (4U * significand) << shift);
  const std::uint64_t lower = scaled(power, (4U * significand - 2U) << shift) + excluded;
  const std::uint64_t upper = scaled(power, (4U * significand + 2U) << shift) - excluded;
  const std::uint64_t tens = (value + 20U) / 40U * 10U;
  const std::uint64_t even = value / 4U & ~std::uint64_t{1}; // a half rounds to the even digit
  const std::uint64_t whole = even + (value > 4U * even + 2U ? 1U : 0U) + (value >= 4U * even + 6U ? 1U : 0U);
  const bool tensInside = (lower <= 4U * tens) & (4U * tens <= upper); // both looked at: no jump to be guessed wrong
  return {whole ^ ((whole ^ tens) & (tensInside ? ~std::uint64_t{0} : 0)), decade};
}

/// The eight digits of a number below 10^8, one in a byte, the first in the lowest byte: halves, pairs and single
/// digits are split off in all lanes at once, dividing by multiplying.
std::uint64_t eightDigits(std::uint32_t number) {
  const std::uint64_t halves = number / 10000U | std::uint64_t{number % 10000U} << 32U;
  const std::uint64_t hundreds = ((halves * 10486U) >> 20U) & 0x7F'0000'007FU;
  const std::uint64_t pairs = hundreds | (halves - 100U * hundreds) << 16U;
  const std::uint64_t tens = ((pairs * 103U) >> 10U) & 0x000F'000F'000F'000FU;
  return tens | (pairs - 10U * tens) << 8U;
}

/// Zeros at the end of eight digits that are not all zero.
int zerosAtEnd(std::uint64_t digits) { return std::countl_zero(digits) / 8; }

/// Sixteen or seventeen digits as text. Copied in steps of fixed length, which are single instructions: what is copied
/// beyond the digits is overwritten or left behind the end.
class DigitText {
public:
  explicit DigitText(std::uint64_t number) {
    constexpr std::uint64_t eight = 100'000'000;
    constexpr std::uint64_t zeros = 0x3030'3030'3030'3030U;
    const std::uint64_t upper = number / eight;
    const std::uint64_t first = upper / eight;
    const std::uint64_t middle = eightDigits(static_cast<std::uint32_t>(upper % eight));
    const std::uint64_t last = eightDigits(static_cast<std::uint32_t>(number % eight));
    put(0, first << 56U | zeros);
    put(8, middle | zeros);
    put(16, last | zeros);
    m_begin = first != 0 ? 7 : 8;
    m_end = last != 0 ? 24 - zerosAtEnd(last) : middle != 0 ? 16 - zerosAtEnd(middle) : 8;
  }
  int all() const { return 24 - m_begin; }
  int significant() const { return m_end - m_begin; } ///< without the zeros at the end
  /// Puts up to six zeros in front.
  void widen(int zeros) { m_begin -= zeros; }
  char first() const { return m_text[static_cast<std::size_t>(m_begin)]; }
  /// Copies the digits from one on; `out` has room for as many characters.
  template <std::size_t Room>
  void copy(int from, char* out) const {
    std::memcpy(out, &m_text[static_cast<std::size_t>(m_begin + from)], Room);
  }

private:
  void put(std::size_t at, std::uint64_t text) { std::memcpy(&m_text[at], &text, sizeof text); }
  std::array<char, 48> m_text{};
  int m_begin = 0;
  int m_end = 0;
};

/// With a point where that is not longer than with an exponent, as std::to_chars() chooses. `before`: digits before the
/// point, fewer than there are; negative: zeros after it.
char* writeDecimal(DigitText text, int before, char* out) {
  const int mostZeros = text.significant() == 1 ? 2 : 3;
  if (before >= -mostZeros) {
    const int zeros = std::max(1 - before, 0); // 0.05 are the digits 005
    text.widen(zeros);
    before += zeros;
    text.copy<16>(0, out);
    out[before] = '.';
    text.copy<20>(before, out + before + 1);
    return out + text.significant() + 1;
  }
  out[0] = text.first();
  out[1] = '.';
  text.copy<16>(1, out + 2);
  out += text.significant() > 1 ? text.significant() + 1 : 1;
  const int exponent = 1 - before; // two digits
  *out++ = 'e';
  *out++ = '-';
  *out++ = static_cast<char>('0' + exponent / 10);
  *out++ = static_cast<char>('0' + exponent % 10);
  return out;
}

} // namespace

char* formatEveryday(double value, char* out) {
  constexpr unsigned fractionBits = 52;
  constexpr int leastExponent = -126; // its decade still has a power of ten
  constexpr int mostBefore = 10;      // further on, copying would leave the room
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << fractionBits) - 1);
  const int exponent = static_cast<int>((bits >> fractionBits) & 0x7FFU) - 1075;
  if (fraction == 0 || exponent < leastExponent || exponent >= 0) {
    return nullptr;
  }
  const Decimal decimal = shortestOf(fraction | (std::uint64_t{1} << fractionBits), exponent);
  const DigitText text(decimal.digits);
  const int before = text.all() + decimal.exponent;
  if (before >= text.significant() || before > mostBefore) {
    return nullptr;
  }
  *out = '-';
  return writeDecimal(text, before, out + (bits >> 63U));
}

#else

char* formatEveryday(double, char*) { return nullptr; }

#endif

} // namespace straightedge
