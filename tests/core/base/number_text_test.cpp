#include "core/base/number_text.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace straightedge {
namespace {

/// Doubles of all kinds: any bits, everyday sizes with any digits, decimals of a few digits, and the neighbours of
/// powers of two and of ten, where a step of the spacing or of the number of digits lies. Always the same ones.
std::vector<double> manyDoubles(int rounds) {
  std::mt19937_64 random(20240607);
  std::vector<double> values;
  const auto neighbours = [&values](double middle) {
    const auto bits = std::bit_cast<std::uint64_t>(middle);
    for (const std::uint64_t at : {bits - 2, bits - 1, bits, bits + 1, bits + 2}) {
      values.push_back(std::bit_cast<double>(at));
    }
  };
  for (int round = 0; round < rounds; ++round) {
    const std::uint64_t bits = random();
    values.push_back(std::bit_cast<double>(bits));
    const std::uint64_t everyday = 1023 - 80 + random() % 140;
    values.push_back(std::bit_cast<double>((bits & 0x800F'FFFF'FFFF'FFFFU) | everyday << 52U));
    values.push_back(static_cast<double>(bits % 20'000'000'000U) / 1e7 - 1000.0);
    neighbours(std::ldexp(1.0, static_cast<int>(random() % 140) - 80));
    neighbours(static_cast<double>(1 + random() % 1000) * std::pow(10.0, static_cast<int>(random() % 40) - 25));
  }
  return values;
}

TEST(NumberText, ReadsBackToTheSameDouble) {
  for (const double value :
       {0.1, 1.0 / 3.0, 1e-9, 100e-9, 89.82120676800716, -1e300, 5e-324, std::numeric_limits<double>::max(), -0.0}) {
    const auto back = parseDouble(formatDouble(value));
    ASSERT_TRUE(back.has_value());
    EXPECT_EQ(*back, value);
    EXPECT_EQ(std::signbit(*back), std::signbit(value));
  }
  EXPECT_EQ(formatDouble(0.1), "0.1");
}

TEST(NumberText, NeverLeavesTheRoom) {
  for (const double value : manyDoubles(2'000)) {
    std::array<char, longestDoubleText + 8> buffer{};
    buffer.fill('~');
    EXPECT_LE(formatDouble(value, buffer.data()), buffer.data() + longestDoubleText);
    EXPECT_EQ(std::string(buffer.data() + longestDoubleText, 8), "~~~~~~~~") << value;
  }
}

TEST(NumberText, ReadsAsTheStandardLibraryDoes) {
  std::mt19937_64 random(4711);
  for (int round = 0; round < 200'000; ++round) {
    // Zero to 24 digits, a point somewhere or nowhere, a sign or none: some are no numbers, some need rounding.
    std::string text(random() % 5, '0');
    text += std::to_string(random() >> random() % 64U);
    const std::size_t point = random() % (text.size() + 3);
    if (point <= text.size()) {
      text.insert(point, ".");
    }
    text.insert(0, random() % 2 == 0 ? "-" : "");
    double expected = 0.0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), expected);
    const bool isNumber = status == std::errc{} && end == text.data() + text.size();
    const auto read = parseDouble(text);
    ASSERT_EQ(read.has_value(), isNumber) << text;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(read.value_or(0.0)), std::bit_cast<std::uint64_t>(isNumber ? expected : 0.0))
        << text;
  }
}

TEST(NumberText, TakesTheWholeTextOrNothing) {
  EXPECT_EQ(parseDouble(" +12.5 "), 12.5);
  EXPECT_EQ(parseDouble("1e3"), 1000.0);
  for (const char* text : {"", " ", "-", ".", "-.", "12x", "1,5", "1.5.", "--1", "+-1", "0x10", "1 2"}) {
    EXPECT_FALSE(parseDouble(text).has_value()) << text;
  }
  EXPECT_TRUE(std::isnan(parseDouble("nan").value_or(0.0)));
}

TEST(NumberText, DecimalCommaExcludesThePoint) {
  EXPECT_EQ(parseDouble("1,5", ','), 1.5);
  EXPECT_FALSE(parseDouble("1.5", ',').has_value());
}

TEST(NumberText, IntegersMustFit) {
  EXPECT_EQ(parseInt("-42"), -42);
  EXPECT_FALSE(parseInt("4.2").has_value());
  EXPECT_FALSE(parseInt("99999999999").has_value());
}

TEST(NumberText, ForPeopleKeepsSignificantDigits) {
  EXPECT_EQ(formatForPeople(0.39832), "0.3983");
  EXPECT_EQ(formatForPeople(123.456), "123.5");
  EXPECT_EQ(formatForPeople(12345.6), "12346");
  EXPECT_EQ(formatForPeople(0.0, 3), "0.00");
}

} // namespace
} // namespace straightedge
