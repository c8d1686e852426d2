#include "devices/instruments/line_parser.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace straightedge::devices {

namespace {

constexpr std::string_view blanks = " \r\n\v\f";

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) {
    return {};
  }
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::unexpected<LineFault> refuse(LineProblem problem, int column, std::string_view text) {
  return std::unexpected(LineFault{problem, column, std::string(text.substr(0, 40))});
}

bool isSeparator(const LineFormat& format, char c) { return format.separators.find(c) != std::string::npos; }

/// The fields between separators. Tabs are blanks unless they separate.
std::vector<std::string_view> fieldsOf(const LineFormat& format, std::string_view line) {
  const bool blankSeparates = isSeparator(format, ' ');
  std::vector<std::string_view> fields;
  std::size_t begin = 0;
  bool afterBlank = false; // the field before was ended by a blank: a separator behind it ends no other one
  for (std::size_t i = 0; i <= line.size(); ++i) {
    if (i < line.size() && !isSeparator(format, line[i])) {
      continue;
    }
    const std::string_view field = trimmed(line.substr(begin, i - begin));
    begin = i + 1;
    const bool blank = blankSeparates && (i == line.size() || line[i] == ' ');
    if (!field.empty() || !(blank || afterBlank)) {
      fields.push_back(field);
    }
    afterBlank = blank && (afterBlank || !field.empty());
  }
  return fields;
}

/// What follows the column's label, up to the end of its field; nothing where no field has the label.
std::optional<std::string_view> labelled(const LineFormat& format, const LineColumn& column, std::string_view line) {
  for (std::size_t at = line.find(column.label); at != std::string_view::npos; at = line.find(column.label, at + 1)) {
    const bool startsField = at == 0 || line[at - 1] == ' ' || isSeparator(format, line[at - 1]);
    if (!startsField) {
      continue;
    }
    std::string_view rest = line.substr(at + column.label.size());
    const auto number = rest.find_first_not_of(" \t:=");
    // "angle2: 5" is not "angle": something must stand between label and number, or the label says so itself.
    const bool separated = number != std::string_view::npos &&
                           (number > 0 || column.label.find_last_of(":= \t") == column.label.size() - 1);
    if (!separated) {
      continue;
    }
    rest.remove_prefix(number);
    const auto ends = [&](std::size_t i) {
      // A blank before the unit ends no field.
      const bool beforeUnit = rest[i] == ' ' && !column.unit.empty() && rest.substr(i + 1).starts_with(column.unit);
      return isSeparator(format, rest[i]) && !beforeUnit;
    };
    std::size_t end = 0;
    while (end < rest.size() && !ends(end)) {
      ++end;
    }
    return trimmed(rest.substr(0, end));
  }
  return std::nullopt;
}

/// The first word of `field`, where a blank may stand before the unit only.
std::expected<double, LineFault> numberIn(const LineFormat& format, const LineColumn& column, int index,
                                          std::string_view field) {
  std::string_view number = field;
  const bool hasUnit = !column.unit.empty() && number.ends_with(column.unit);
  if (hasUnit) {
    number = trimmed(number.substr(0, number.size() - column.unit.size()));
  } else if (column.unitNeeded) {
    return refuse(LineProblem::WrongUnit, index, field);
  }
  const auto parsed = parseDouble(number, format.decimalPoint);
  if (!parsed) {
    return refuse(LineProblem::NotANumber, index, field);
  }
  const double value = column.scale * *parsed + column.offset;
  if (!std::isfinite(value)) {
    return refuse(LineProblem::NotFinite, index, field);
  }
  if (value < column.least || value > column.most) {
    return refuse(LineProblem::OutOfLimits, index, field);
  }
  return value;
}

bool isText(std::string_view line) {
  return std::ranges::none_of(line, [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte < 0x20U && c != '\t') || byte == 0x7FU;
  });
}

} // namespace

std::expected<std::vector<double>, LineFault> parseLine(const LineFormat& format, std::string_view line) {
  if (line.size() > longestLine) {
    return refuse(LineProblem::TooLong, -1, line);
  }
  line = trimmed(line);
  if (line.empty()) {
    return refuse(LineProblem::Empty, -1, line);
  }
  if (!isText(line)) {
    return refuse(LineProblem::NotText, -1, line);
  }
  if (!line.starts_with(format.prefix)) {
    return refuse(LineProblem::WrongPrefix, -1, line);
  }
  line.remove_prefix(format.prefix.size());
  const auto fields = fieldsOf(format, line);
  if (format.fieldCount > 0 && fields.size() != static_cast<std::size_t>(format.fieldCount)) {
    return refuse(LineProblem::WrongFields, -1, line);
  }
  std::vector<double> values;
  values.reserve(format.columns.size());
  for (std::size_t i = 0; i < format.columns.size(); ++i) {
    const LineColumn& column = format.columns[i];
    const int index = static_cast<int>(i);
    std::optional<std::string_view> field;
    if (!column.label.empty()) {
      field = labelled(format, column, line);
      if (!field) {
        return refuse(LineProblem::LabelMissing, index, line);
      }
    } else if (column.index < 1 || static_cast<std::size_t>(column.index) > fields.size()) {
      return refuse(LineProblem::WrongFields, index, line);
    } else {
      field = fields[static_cast<std::size_t>(column.index) - 1];
    }
    const auto value = numberIn(format, column, index, *field);
    if (!value) {
      return std::unexpected(value.error());
    }
    values.push_back(*value);
  }
  return values;
}

std::string describe(const LineFault& fault, const LineFormat& format) {
  std::string subject = "the line";
  if (fault.column >= 0 && static_cast<std::size_t>(fault.column) < format.columns.size()) {
    const LineColumn& column = format.columns[static_cast<std::size_t>(fault.column)];
    subject = column.label.empty() ? "field " + std::to_string(column.index) : "field '" + column.label + "'";
    subject += column.quantity.empty() ? "" : " (" + column.quantity + ")";
  }
  std::string shown = "'";
  for (const char c : fault.text) {
    shown += static_cast<unsigned char>(c) < 0x20U || static_cast<unsigned char>(c) > 0x7EU ? '?' : c;
  }
  shown += "'";
  switch (fault.problem) {
  case LineProblem::Empty:
    return "the line is empty";
  case LineProblem::TooLong:
    return "the line is longer than " + std::to_string(longestLine) + " bytes";
  case LineProblem::NotText:
    return "the line holds bytes that are no text: " + shown;
  case LineProblem::WrongPrefix:
    return "the line does not begin with '" + format.prefix + "': " + shown;
  case LineProblem::WrongFields:
    return subject + " is not there, or the line has another number of fields: " + shown;
  case LineProblem::LabelMissing:
    return subject + " is not there: " + shown;
  case LineProblem::NotANumber:
    return subject + " is not a number: " + shown;
  case LineProblem::NotFinite:
    return subject + " is not a finite number: " + shown;
  case LineProblem::WrongUnit:
    return subject + " has not the unit it should have: " + shown;
  case LineProblem::OutOfLimits:
    return subject + " is out of its limits: " + shown;
  }
  return subject;
}

std::string problemOf(const LineFormat& format) {
  if (format.columns.empty()) {
    return "no column is named";
  }
  if (format.decimalPoint != '.' && format.decimalPoint != ',') {
    return "the decimal point is neither . nor ,";
  }
  if (isSeparator(format, format.decimalPoint)) {
    return "the decimal point separates fields, too";
  }
  for (const LineColumn& column : format.columns) {
    if (column.label.empty() && (column.index < 1 || column.index > 64)) {
      return "a column has neither a label nor a number from 1 to 64";
    }
    if (format.fieldCount > 0 && column.label.empty() && column.index > format.fieldCount) {
      return "a column lies beyond the number of fields";
    }
    if (!std::isfinite(column.scale) || column.scale == 0.0 || !std::isfinite(column.offset)) {
      return "a scale is zero, or a scale or offset is not finite";
    }
    if (!(column.least < column.most)) {
      return "the lower limit of a column is not below its upper limit";
    }
    if (column.unitNeeded && column.unit.empty()) {
      return "a column needs a unit but names none";
    }
  }
  return {};
}

} // namespace straightedge::devices
