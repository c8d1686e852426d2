// Bytes of a board that prints by itself, cut into lines and read: banner and partial first line tolerated, everything
// that is no reading counted.
#pragma once

#include "devices/instruments/line_parser.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace straightedge::devices {

struct LineCounts {
  std::int64_t readings = 0;
  std::int64_t banner = 0;    ///< lines before the first reading that were none, the partial first line among them
  std::int64_t rejected = 0;  ///< lines after it that were none; empty lines and other kinds of lines do not count
  std::int64_t notFinite = 0; ///< of `rejected`: nan and inf
};

class LineReader {
public:
  explicit LineReader(LineFormat format, char end = '\n') : m_format(std::move(format)), m_end(end) {}

  /// The next line is begun already, its front is lost: it is thrown away, however well it reads. "23.5" might be the
  /// rest of "123.5". To be called after opening and clearing.
  void startInsideLine();

  /// Readings in `bytes` together with what was left over before: one list of columns a line.
  std::vector<std::vector<double>> take(std::string_view bytes);
  void take(std::string_view bytes, std::vector<std::vector<double>>& readings); ///< behind those that are there

  const LineFormat& format() const { return m_format; }
  const LineCounts& counts() const { return m_counts; }
  const std::optional<LineFault>& lastFault() const { return m_lastFault; } ///< of the last line that was no reading

private:
  void takeLine(std::string_view line, std::vector<std::vector<double>>& readings);

  LineFormat m_format;
  char m_end;
  std::string m_partial;
  bool m_skip = true;     ///< until the next end of line
  bool m_tooLong = false; ///< the line under way outgrew longestLine
  LineCounts m_counts;
  std::optional<LineFault> m_lastFault;
};

} // namespace straightedge::devices
