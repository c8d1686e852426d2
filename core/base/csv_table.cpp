#include "core/base/csv_table.h"

#include "core/base/csv_text.h"
#include "core/base/file_bytes.h"
#include "core/base/number_text.h"

#include <algorithm>

namespace straightedge {

namespace {

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f'; }

bool isNumber(std::string_view text, char separator) {
  return parseDouble(text).has_value() || (separator != ',' && parseDouble(text, ',').has_value());
}

std::string cellCount(std::size_t count) { return std::to_string(count) + (count == 1 ? " column" : " columns"); }

} // namespace

Result<CsvTable> CsvTable::read(const std::string& path) {
  auto bytes = readFileBytes(path);
  if (!bytes) {
    return std::unexpected(std::move(bytes.error()));
  }
  return parse(std::move(*bytes), inputName(path));
}

Result<CsvTable> CsvTable::parse(std::string bytes, const std::string& name) {
  auto text = csvText(std::move(bytes), name);
  if (!text) {
    return std::unexpected(std::move(text.error()));
  }
  CsvTable table;
  table.m_name = name;
  table.m_text = std::move(*text);
  if (auto done = table.split(); !done) {
    return std::unexpected(std::move(done.error()));
  }
  table.findDecimalPoint();
  return table;
}

Result<void> CsvTable::split() {
  std::size_t begin = 0;
  // Spreadsheets may write "sep=;" as the first line.
  if (m_text.starts_with("sep=") && m_text.size() > 5 && (m_text[5] == '\n' || m_text[5] == '\r')) {
    m_layout.separator = m_text[4];
    begin = m_text.find('\n') + 1;
    m_linesSplit = 1;
  } else {
    m_layout.separator = findCsvSeparator(m_text);
  }
  if (auto done = splitFrom(begin); !done) {
    return done;
  }
  if (m_columns == 0) {
    return fail(ErrorKind::Input, "the file holds nothing but comments and blank lines",
                "record or export the data again", m_name);
  }
  if (m_lines.empty()) {
    return fail(ErrorKind::Input, "the file holds a header but no data", "record or export the data again", m_name);
  }
  return {};
}

bool CsvTable::readOn(std::string& text) {
  m_cells.clear();
  m_lines.clear();
  m_text.swap(text);
  if (hasControlBytes(m_text) || !splitFrom(0)) {
    return false;
  }
  if (!m_decimalPointFound) {
    findDecimalPoint();
    return m_layout.decimalPoint == '.'; // what was read so far may have been decimal commas without a comma
  }
  return true;
}

Result<void> CsvTable::splitFrom(std::size_t begin) {
  while (begin < m_text.size()) {
    const std::size_t line = ++m_linesSplit;
    const std::size_t end = std::min(m_text.find('\n', begin), m_text.size());
    if (end - begin > longestCsvLine) {
      return fail(ErrorKind::Input, "the line is longer than " + std::to_string(longestCsvLine) + " characters",
                  "name a CSV file with one reading in a line", m_name + ":" + std::to_string(line));
    }
    if (auto added = addRow(begin, end, line); !added) {
      return added;
    }
    begin = end + 1;
  }
  return {};
}

Result<void> CsvTable::addRow(std::size_t begin, std::size_t end, std::size_t line) {
  const char separator = m_layout.separator;
  char* const all = m_text.data();
  std::size_t first = begin;
  while (first < end && isBlank(all[first]) && !(all[first] == '\t' && separator == '\t')) {
    ++first;
  }
  if (first == end || all[first] == '#') {
    return {};
  }
  const std::size_t cellsBefore = m_cells.size();
  std::size_t cellBegin = begin;
  bool anyText = false;
  while (true) {
    // A cell that begins with a quote runs to its closing quote; "" inside stands for one.
    std::size_t cellEnd = 0;
    std::size_t contentBegin = cellBegin;
    while (contentBegin < end && all[contentBegin] == ' ') {
      ++contentBegin;
    }
    std::size_t contentEnd = 0;
    if (contentBegin < end && all[contentBegin] == '"') {
      std::size_t written = ++contentBegin;
      std::size_t at = contentBegin;
      while (at < end && (all[at] != '"' || (at + 1 < end && all[at + 1] == '"'))) {
        at += all[at] == '"' ? 1U : 0U;
        all[written++] = all[at++];
      }
      if (at >= end) {
        return fail(ErrorKind::Input, "a quoted field does not end in this line", "close the quote or remove it",
                    m_name + ":" + std::to_string(line));
      }
      contentEnd = written;
      cellEnd = std::min(m_text.find(m_layout.separator, at), end);
    } else {
      cellEnd = cellBegin;
      while (cellEnd < end && all[cellEnd] != separator) {
        ++cellEnd;
      }
      contentBegin = cellBegin;
      contentEnd = cellEnd;
    }
    while (contentBegin < contentEnd && isBlank(all[contentBegin])) {
      ++contentBegin;
    }
    while (contentEnd > contentBegin && isBlank(all[contentEnd - 1])) {
      --contentEnd;
    }
    anyText = anyText || contentEnd > contentBegin;
    m_cells.push_back(
        {static_cast<std::uint32_t>(contentBegin), static_cast<std::uint32_t>(contentEnd - contentBegin)});
    if (cellEnd >= end) {
      break;
    }
    cellBegin = cellEnd + 1;
  }
  if (!anyText) { // spreadsheets export empty rows as ",,,"
    m_cells.resize(cellsBefore);
    return {};
  }
  if (m_columns == 0) {
    m_columns = m_cells.size();
    const auto numeric = [&](const Cell& cell) { return isNumber(text(cell), m_layout.separator); };
    m_layout.hasHeader = std::ranges::none_of(m_cells, numeric);
    if (m_layout.hasHeader) {
      for (const Cell& cell : m_cells) {
        m_titles.emplace_back(text(cell));
      }
      m_cells.clear();
      return {};
    }
  }
  std::size_t count = m_cells.size() - cellsBefore;
  while (count > m_columns && m_cells.back().length == 0) { // separators at the end of the row
    m_cells.pop_back();
    --count;
  }
  if (count != m_columns) {
    const char* remedy = m_layout.separator == ',' && count > m_columns
                             ? "check the row; a decimal comma needs ; or tab between the columns"
                             : "check the row and the separator";
    return fail(ErrorKind::Input, "the row has " + cellCount(count) + " instead of " + std::to_string(m_columns),
                remedy, m_name + ":" + std::to_string(line));
  }
  m_lines.push_back(line);
  return {};
}

void CsvTable::findDecimalPoint() {
  if (m_layout.separator == ',') {
    m_decimalPointFound = true;
    return;
  }
  for (const Cell& cell : m_cells) {
    const auto content = text(cell);
    const bool comma = content.find(',') != std::string_view::npos;
    const bool point = content.find('.') != std::string_view::npos;
    if (comma != point && parseDouble(content, comma ? ',' : '.')) {
      m_layout.decimalPoint = comma ? ',' : '.';
      m_decimalPointFound = true;
      return;
    }
  }
}

std::string_view CsvTable::title(std::size_t column) const {
  return column < m_titles.size() ? std::string_view(m_titles[column]) : std::string_view();
}

std::string_view CsvTable::cell(std::size_t row, std::size_t column) const {
  return text(m_cells[row * m_columns + column]);
}

std::string CsvTable::where(std::size_t row) const { return m_name + ":" + std::to_string(m_lines[row]); }

std::string CsvTable::columnName(std::size_t column) const {
  const auto named = title(column);
  return named.empty() ? "column " + std::to_string(column + 1) : "column \"" + std::string(named) + "\"";
}

std::optional<double> CsvTable::numberIfAny(std::size_t row, std::size_t column) const {
  return parseDouble(cell(row, column), m_layout.decimalPoint);
}

Result<double> CsvTable::number(std::size_t row, std::size_t column) const {
  if (const auto value = numberIfAny(row, column)) {
    return *value;
  }
  const auto content = cell(row, column);
  if (content.empty()) {
    return fail(ErrorKind::Input, columnName(column) + " is empty", "fill it in or remove the row", where(row));
  }
  constexpr std::size_t shown = 40;
  const std::string quoted = "\"" + std::string(content.substr(0, shown)) + (content.size() > shown ? "…" : "") + "\"";
  const char* remedy = m_layout.decimalPoint == ',' && content.find('.') != std::string_view::npos
                           ? "the file's decimal mark is a comma; use it in every row"
                           : "correct it or remove the row";
  return fail(ErrorKind::Input, columnName(column) + " holds " + quoted + ", which is no number", remedy, where(row));
}

} // namespace straightedge
