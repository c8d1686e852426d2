#include "core/base/csv_table.h"
#include "core/base/csv_text.h"

#include <algorithm>
#include <array>

namespace straightedge {

namespace {

bool isSkipped(std::string_view line) {
  const auto first = line.find_first_not_of(" \t\r");
  return first == std::string_view::npos || line[first] == '#';
}

std::size_t countOutsideQuotes(std::string_view line, char wanted) {
  bool quoted = false;
  std::size_t count = 0;
  for (const char c : line) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == wanted && !quoted) {
      ++count;
    }
  }
  return count;
}

} // namespace

char findCsvSeparator(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty() && lines.size() < csvSampledLines) {
    const auto end = text.find('\n');
    const auto line = text.substr(0, std::min(end, longestCsvLine));
    if (!isSkipped(line)) {
      lines.push_back(line);
    }
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  // Tab and semicolon first: with them a comma may be a decimal mark.
  constexpr std::array<char, 3> candidates{'\t', ';', ','};
  char best = ',';
  std::size_t mostLines = 0;
  for (const char candidate : candidates) {
    const auto with = static_cast<std::size_t>(std::count_if(
        lines.begin(), lines.end(), [&](std::string_view line) { return countOutsideQuotes(line, candidate) > 0; }));
    if (with > mostLines) {
      best = candidate;
      mostLines = with;
    }
  }
  return best;
}

std::vector<std::string_view> splitCsvLine(std::string_view line, char separator) {
  std::vector<std::string_view> cells;
  std::size_t begin = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') {
      quoted = !quoted;
    } else if (line[i] == separator && !quoted) {
      cells.push_back(line.substr(begin, i - begin));
      begin = i + 1;
    }
  }
  cells.push_back(line.substr(begin));
  return cells;
}

std::string csvCell(std::string_view text, char separator) {
  if (text.find_first_of("\"\r\n") == std::string_view::npos && text.find(separator) == std::string_view::npos) {
    return std::string(text);
  }
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') {
      quoted += '"';
    }
    quoted += c;
  }
  return quoted + '"';
}

} // namespace straightedge
