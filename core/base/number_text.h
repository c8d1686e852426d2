// Numbers to and from text, without locale: what is written reads back to the same double.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace straightedge {

/// Shortest decimal text that reads back to exactly `value`; "nan", "inf", "-inf" where it is not finite.
std::string formatDouble(double value);

/// The same without allocation, for long tables: writes to `out`, which has room for longestDoubleText characters, and
/// gives the end.
inline constexpr int longestDoubleText = 32;
char* formatDouble(double value, char* out);

/// `value` with `digits` significant digits for people (messages, labels), never in a file that is read back.
std::string formatForPeople(double value, int digits = 4);

/// The whole of `text` (blanks around it allowed) as a number; nothing if it is not one. Accepts nan and inf.
std::optional<double> parseDouble(std::string_view text, char decimalPoint = '.');

/// The whole of `text` as an integer; nothing if it is not one or does not fit.
std::optional<int> parseInt(std::string_view text);

} // namespace straightedge
