#include "app/cli/reading_lines.h"

#include "core/base/number_text.h"
#include "core/base/plain_number.h"

#include <cstring>

namespace straightedge::cli {

namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) {
    text.remove_prefix(1);
  }
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) {
    text.remove_suffix(1);
  }
  return text;
}

std::string_view unquoted(std::string_view cell) {
  const std::string_view text = trimmed(cell);
  return text.size() > 1 && text.front() == '"' && text.back() == '"' ? text.substr(1, text.size() - 2) : cell;
}

std::optional<Error> problem(std::string what, std::string remedy) {
  return Error{ErrorKind::Input, std::move(what), std::move(remedy), {}};
}

std::optional<Error> wrongCount(std::size_t cells, const ReadingLayout& layout) {
  return problem("the row has " + std::to_string(cells) + (cells == 1 ? " column" : " columns") + " instead of " +
                     std::to_string(layout.columns),
                 "check the row and the separator");
}

std::optional<Error> readCell(std::string_view cell, const WantedColumn& wanted, const ReadingLayout& layout,
                              double& value) {
  if (const auto number = parseDouble(cell, layout.csv.decimalPoint)) {
    value = *number;
    return std::nullopt;
  }
  constexpr std::size_t shown = 40;
  return problem("the " + wanted.meaning + " is \"" + std::string(trimmed(cell).substr(0, shown)) +
                     "\", which is no number",
                 "correct it or remove the row");
}

std::optional<Error> readQuoted(std::string_view row, const ReadingLayout& layout, std::span<double> values) {
  const auto cells = splitCsvLine(row, layout.csv.separator);
  if (cells.size() != layout.columns) {
    return wrongCount(cells.size(), layout);
  }
  for (const WantedColumn& wanted : layout.wanted) {
    if (auto wrong = readCell(unquoted(cells[wanted.column]), wanted, layout, values[wanted.value])) {
      return wrong;
    }
  }
  return std::nullopt;
}

/// Reads a row whose wanted cells are plain numbers and in which nothing is quoted, as nearly all are; false for any
/// other, which readCells() looks into then.
bool readPlainCells(std::string_view row, const ReadingLayout& layout, std::span<double> values) {
  const char separator = layout.csv.separator;
  const char* at = row.data();
  const char* const end = at + row.size();
  auto wanted = layout.wanted.begin();
  for (std::size_t cell = 0;; ++cell, ++at) {
    if (wanted != layout.wanted.end() && wanted->column == cell) {
      at = readPlainNumber(at, end, layout.csv.decimalPoint, values[wanted->value]);
      if (at == nullptr || (at != end && *at != separator)) {
        return false;
      }
      ++wanted;
    }
    while (at != end && *at != separator) {
      if (*at == '"') {
        return false;
      }
      ++at;
    }
    if (at == end) {
      return cell + 1 == layout.columns;
    }
  }
}

/// A line of neither kind that is looked for in LineWalk::next(), told by its first character.
bool beginsLikeARow(std::string_view line) {
  if (line.empty()) {
    return false;
  }
  const char first = line.front();
  return first != ' ' && first != '\t' && first != '#' && first != ',' && first != ';';
}

} // namespace

bool LineWalk::next(ReadingLine& line) {
  if (m_rest.empty()) {
    return false;
  }
  ++m_lines;
  const void* hit = std::memchr(m_rest.data(), '\n', m_rest.size());
  const std::size_t whole =
      hit == nullptr ? m_rest.size() : static_cast<std::size_t>(static_cast<const char*>(hit) - m_rest.data()) + 1;
  std::size_t length = hit == nullptr ? whole : whole - 1;
  if (length > 0 && m_rest[length - 1] == '\r') {
    --length;
  }
  line.content = m_rest.substr(0, length);
  line.end = m_rest.substr(length, whole - length);
  m_rest.remove_prefix(whole);
  if (!m_headerDue && beginsLikeARow(line.content)) {
    line.kind = LineKind::Row;
    return true;
  }
  const auto firstSign = line.content.find_first_not_of(" \t");
  if (firstSign == std::string_view::npos || line.content[firstSign] == '#' ||
      (m_headerDue && line.content.size() == 5 && line.content.starts_with("sep="))) {
    line.kind = LineKind::Passed;
  } else if (m_headerDue) {
    line.kind = LineKind::Header;
    m_headerDue = false;
  } else {
    const bool empty = line.content.find_first_not_of(std::string_view(", ;\t")) == std::string_view::npos;
    line.kind = empty ? LineKind::EmptyRow : LineKind::Row;
  }
  return true;
}

std::optional<Error> readCells(std::string_view row, const ReadingLayout& layout, std::span<double> values) {
  if (readPlainCells(row, layout, values)) {
    return std::nullopt;
  }
  if (std::memchr(row.data(), '"', row.size()) != nullptr) {
    return readQuoted(row, layout, values);
  }
  std::optional<Error> wrong;
  std::size_t cells = 0;
  std::size_t begin = 0;
  auto wanted = layout.wanted.begin();
  while (true) {
    const void* hit = std::memchr(row.data() + begin, layout.csv.separator, row.size() - begin);
    const std::size_t end =
        hit == nullptr ? row.size() : static_cast<std::size_t>(static_cast<const char*>(hit) - row.data());
    if (wanted != layout.wanted.end() && wanted->column == cells) {
      if (!wrong) {
        wrong = readCell(row.substr(begin, end - begin), *wanted, layout, values[wanted->value]);
      }
      ++wanted;
    }
    ++cells;
    if (hit == nullptr) {
      break;
    }
    begin = end + 1;
  }
  return cells == layout.columns ? wrong : wrongCount(cells, layout); // a row cut short is told as that
}

} // namespace straightedge::cli
