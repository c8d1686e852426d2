#include "app/cli/row_correction.h"

#include "core/base/csv_text.h"
#include "core/base/number_text.h"

#include <algorithm>
#include <cstring>

namespace straightedge::cli {

namespace {

constexpr std::string_view addedTitle = "corrected_deg";

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) {
    text.remove_prefix(1);
  }
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) {
    text.remove_suffix(1);
  }
  return text;
}

/// The cell of a line without quotes, and the number of cells in it.
struct FoundCell {
  std::string_view text;
  std::size_t cells = 0;
};

FoundCell findCell(std::string_view line, char separator, std::size_t column) {
  FoundCell found;
  std::size_t begin = 0;
  while (true) {
    const void* hit = std::memchr(line.data() + begin, separator, line.size() - begin);
    const std::size_t end =
        hit == nullptr ? line.size() : static_cast<std::size_t>(static_cast<const char*>(hit) - line.data());
    if (found.cells++ == column) {
      found.text = line.substr(begin, end - begin);
    }
    if (hit == nullptr) {
      return found;
    }
    begin = end + 1;
  }
}

FoundCell findQuotedCell(std::string_view line, char separator, std::size_t column) {
  const auto cells = splitCsvLine(line, separator);
  FoundCell found{{}, cells.size()};
  if (column < cells.size()) {
    found.text = trimmed(cells[column]);
    if (found.text.size() > 1 && found.text.front() == '"' && found.text.back() == '"') {
      found.text = found.text.substr(1, found.text.size() - 2);
    }
  }
  return found;
}

class Writer {
public:
  Writer(const RowCorrection& correction, CorrectedBlock& result) : m_correction(correction), m_result(result) {}

  /// A line without its newline but with the CR it may end with.
  void line(std::string_view text, bool& headerDue);
  void pass(std::string_view text) {
    std::memcpy(m_result.bytes.data() + m_result.used, text.data(), text.size());
    m_result.used += text.size();
  }
  bool failed() const { return m_result.problem.has_value(); }

private:
  void row(std::string_view content);
  void number(double value);
  void blame(std::string what, std::string remedy) {
    m_result.problem = Error{ErrorKind::Input, std::move(what), std::move(remedy), {}};
  }

  const RowCorrection& m_correction;
  CorrectedBlock& m_result;
};

void Writer::line(std::string_view text, bool& headerDue) {
  const bool carriageReturn = !text.empty() && text.back() == '\r';
  const std::string_view content = text.substr(0, text.size() - (carriageReturn ? 1 : 0));
  const auto firstSign = content.find_first_not_of(" \t");
  if (firstSign == std::string_view::npos || content[firstSign] == '#' ||
      (headerDue && content.starts_with("sep=") && content.size() == 5)) {
    pass(text);
    return;
  }
  pass(content);
  if (headerDue) {
    headerDue = false;
    pass({&m_correction.layout.csv.separator, 1});
    pass(addedTitle);
  } else {
    row(content);
  }
  if (carriageReturn) {
    pass("\r");
  }
}

void Writer::row(std::string_view content) {
  const ReadingLayout& layout = m_correction.layout;
  const char separator = layout.csv.separator;
  const bool quoted = std::memchr(content.data(), '"', content.size()) != nullptr;
  const FoundCell cell = quoted ? findQuotedCell(content, separator, layout.sensorColumn)
                                : findCell(content, separator, layout.sensorColumn);
  pass({&separator, 1});
  if (content.find_first_not_of(std::string_view(", ;\t")) == std::string_view::npos) {
    return; // an empty row of a spreadsheet
  }
  if (cell.cells != layout.columns) {
    blame("the row has " + std::to_string(cell.cells) + (cell.cells == 1 ? " column" : " columns") + " instead of " +
              std::to_string(layout.columns),
          "check the row and the separator");
    return;
  }
  const auto sensor = parseDouble(cell.text, layout.csv.decimalPoint);
  if (!sensor) {
    constexpr std::size_t shown = 40;
    blame("the sensor angle is \"" + std::string(trimmed(cell.text).substr(0, shown)) + "\", which is no number",
          "correct it or remove the row");
    return;
  }
  if (!(*sensor >= 0.0 && *sensor <= 360.0)) {
    blame("the sensor angle " + formatDouble(*sensor) + " lies outside 0 to 360°", "correct it or remove the row");
    return;
  }
  number(angle::correctedDeg(m_correction.model, m_correction.direction, *sensor));
  ++m_result.rows;
}

void Writer::number(double value) {
  char* const begin = m_result.bytes.data() + m_result.used;
  char* const end = formatDouble(value, begin);
  if (m_correction.layout.csv.decimalPoint != '.') {
    std::replace(begin, end, '.', m_correction.layout.csv.decimalPoint);
  }
  m_result.used += static_cast<std::size_t>(end - begin);
}

} // namespace

void correctRows(const RowCorrection& correction, std::string_view block, bool first, CorrectedBlock& result) {
  const auto newlines = static_cast<std::size_t>(std::count(block.begin(), block.end(), '\n'));
  // Every line may grow by a separator and a number, or by the title.
  const std::size_t room = block.size() + (newlines + 1) * (longestDoubleText + 1);
  if (result.bytes.size() < room) {
    result.bytes.resize(room);
  }
  result.used = 0;
  result.lines = 0;
  result.rows = 0;
  result.problem.reset();
  Writer writer(correction, result);
  bool headerDue = first && correction.layout.csv.hasHeader;
  if (first) {
    const std::size_t mark = byteOrderMarkLength(block);
    writer.pass(block.substr(0, mark));
    block.remove_prefix(mark);
  }
  while (!block.empty() && !writer.failed()) {
    const void* hit = std::memchr(block.data(), '\n', block.size());
    const std::size_t end =
        hit == nullptr ? block.size() : static_cast<std::size_t>(static_cast<const char*>(hit) - block.data());
    ++result.lines;
    writer.line(block.substr(0, end), headerDue);
    if (hit == nullptr) {
      return;
    }
    writer.pass("\n");
    block.remove_prefix(end + 1);
  }
}

} // namespace straightedge::cli
