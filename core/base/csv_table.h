// A CSV file as rows and columns of text, with the line of every row for messages.
#pragma once

#include "core/base/error.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace straightedge {

/// How the text is laid out; found by looking at it.
struct CsvLayout {
  char separator = ',';    ///< , ; or tab
  char decimalPoint = '.'; ///< . or, with ; or tab, a comma
  bool hasHeader = false;  ///< the first row holds no number
};

/// `,` `;` or tab; decimal comma with `;` or tab; `#` comment lines and blank lines left out; UTF-8 with or without
/// byte-order mark; LF or CRLF; quoted fields ("" inside for a quote) that end in their line.
/// Cells are trimmed of blanks. Immutable; any thread.
class CsvTable {
public:
  /// Errors (Input): those of checkCsvText(); a row with more or fewer cells than the first (FILE:LINE); a line longer
  /// than longestCsvLine; no row at all; nothing but a header.
  static Result<CsvTable> parse(std::string bytes, const std::string& name);
  /// `path` or "-" for standard input.
  static Result<CsvTable> read(const std::string& path);

  /// Goes on: the rows of the lines that follow in the file take the place of those so far, and `text` takes their
  /// memory. So a long file is read without all of its cells in memory at once; the first part must hold
  /// csvSampledLines rows. false: these lines are not as parse() wants them or as the first part promised, the table
  /// is of no more use; parse() of the whole text tells what is wrong.
  bool readOn(std::string& text);

  const std::string& name() const { return m_name; } ///< of the file, for messages
  const CsvLayout& layout() const { return m_layout; }
  std::size_t columns() const { return m_columns; }
  std::size_t rows() const { return m_lines.size(); }
  std::string_view title(std::size_t column) const; ///< empty without a header
  std::string_view cell(std::size_t row, std::size_t column) const;
  std::size_t line(std::size_t row) const { return m_lines[row]; } ///< 1-based, comments and blank lines counted
  std::string where(std::size_t row) const;                        ///< "FILE:LINE"

  /// Nothing if the cell is no number. NaN and infinity are numbers here.
  std::optional<double> numberIfAny(std::size_t row, std::size_t column) const;
  /// Errors (Input, FILE:LINE): the cell is empty or is no number.
  Result<double> number(std::size_t row, std::size_t column) const;
  /// The column in messages: its title in quotes, or "column 2".
  std::string columnName(std::size_t column) const;

private:
  struct Cell {
    std::uint32_t begin = 0;
    std::uint32_t length = 0;
  };
  CsvTable() = default;
  Result<void> split();
  Result<void> splitFrom(std::size_t begin);
  Result<void> addRow(std::size_t begin, std::size_t end, std::size_t line);
  void findDecimalPoint();
  std::string_view text(const Cell& cell) const { return std::string_view(m_text).substr(cell.begin, cell.length); }

  std::string m_name;
  std::string m_text; ///< cells point into it; quoted cells are unescaped in place
  CsvLayout m_layout;
  std::size_t m_columns = 0;
  bool m_decimalPointFound = false;
  std::size_t m_linesSplit = 0;
  std::vector<std::string> m_titles;
  std::vector<Cell> m_cells; ///< row by row
  std::vector<std::size_t> m_lines;
};

/// Lines of a text, comments and blank ones left out, that tell how it is laid out.
inline constexpr std::size_t csvSampledLines = 24;

/// The cells of one line, split at `separator` outside quotes; neither trimmed nor unescaped.
std::vector<std::string_view> splitCsvLine(std::string_view line, char separator);

/// The separator that the first lines of `text` agree on; a comma where there is none.
char findCsvSeparator(std::string_view text);

/// `text` as a cell: quoted where it needs to be.
std::string csvCell(std::string_view text, char separator = ',');

} // namespace straightedge
