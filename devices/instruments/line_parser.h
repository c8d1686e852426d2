// Lines of text that boards print, as `Serial.print` makes them: fields, labels, units. Turns one line into values or
// says what is wrong with it.
#pragma once

#include <cstdint>
#include <expected>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace straightedge::devices {

/// One value of a line: value = scale · number + offset.
struct LineColumn {
  std::string quantity;    ///< what it is, for messages and to find it by: "angle"
  int index = 1;           ///< which field of the line, from 1; not used where there is a label
  std::string label;       ///< text in front of the number ("angle (rad)"); `:` `=` and blanks may follow it
  std::string unit;        ///< text that may follow the number directly or after a blank: "deg", "T"; taken off
  bool unitNeeded = false; ///< true: a number without the unit is refused
  double scale = 1.0;
  double offset = 0.0;
  double least = -std::numeric_limits<double>::infinity(); ///< of the value; beyond is refused
  double most = std::numeric_limits<double>::infinity();
};

struct LineFormat {
  std::string separators = ",;\t"; ///< each ends a field, blanks around fields do not count; a blank among them: runs
                                   ///< of blanks end a field, too
  char decimalPoint = '.';
  std::string prefix; ///< lines that do not begin with it are no readings; empty: all do
  int fieldCount = 0; ///< how many fields a whole line has; 0: any number
  std::vector<LineColumn> columns;
};

enum class LineProblem : std::uint8_t {
  Empty,
  TooLong,      ///< longer than longestLine: no line of a board
  NotText,      ///< bytes that no text has: wrong baud rate, a damaged line
  WrongPrefix,  ///< a line of another kind
  WrongFields,  ///< fewer fields than a column needs, or another number than fieldCount
  LabelMissing, ///< no field with the column's label
  NotANumber,
  NotFinite, ///< nan, inf
  WrongUnit,
  OutOfLimits,
};

inline constexpr std::size_t longestLine = 1024;

struct LineFault {
  LineProblem problem = LineProblem::Empty;
  int column = -1;  ///< index into LineFormat::columns; -1 where the whole line is to blame
  std::string text; ///< what stood there, at most 40 bytes
};

/// The columns' values, in their order. `line` without its end; a '\r' at the end does not count. Any thread.
std::expected<std::vector<double>, LineFault> parseLine(const LineFormat& format, std::string_view line);

/// "column 2 (angle) is not a number: 'nan'".
std::string describe(const LineFault& fault, const LineFormat& format);

/// What is wrong with the format itself, in one clause; empty: nothing.
std::string problemOf(const LineFormat& format);

} // namespace straightedge::devices
