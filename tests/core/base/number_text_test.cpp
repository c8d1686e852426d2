#include "core/base/number_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace straightedge {
namespace {

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

TEST(NumberText, TakesTheWholeTextOrNothing) {
  EXPECT_EQ(parseDouble(" +12.5 "), 12.5);
  EXPECT_EQ(parseDouble("1e3"), 1000.0);
  for (const char* text : {"", " ", "12x", "1,5", "--1", "+-1", "0x10", "1 2"}) {
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
