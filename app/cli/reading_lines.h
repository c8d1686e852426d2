// The lines of a block of readings, told apart, and the cells of a row that matter. Quick: nothing is copied.
#pragma once

#include "app/cli/reading_layout.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace straightedge::cli {

enum class LineKind : std::uint8_t {
  Passed, ///< comment, blank line, a spreadsheet's sep=
  Header,
  EmptyRow, ///< separators only, as spreadsheets leave them
  Row,
};

struct ReadingLine {
  LineKind kind = LineKind::Passed;
  std::string_view content;
  std::string_view end; ///< "\n", "\r\n", "\r" or, at the end of the file, nothing
};

class LineWalk {
public:
  /// `headerDue`: the first row is the header.
  LineWalk(std::string_view block, bool headerDue) : m_rest(block), m_headerDue(headerDue) {}
  bool next(ReadingLine& line);
  std::size_t lines() const { return m_lines; }

private:
  std::string_view m_rest;
  bool m_headerDue;
  std::size_t m_lines = 0;
};

/// Reads the wanted cells of `row` into `values`, as many as the layout wants. What is wrong, or nothing.
std::optional<Error> readCells(std::string_view row, const ReadingLayout& layout, std::span<double> values);

} // namespace straightedge::cli
