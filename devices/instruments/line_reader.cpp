#include "devices/instruments/line_reader.h"

#include <utility>

namespace straightedge::devices {

void LineReader::startInsideLine() {
  m_partial.clear();
  m_skip = true;
  m_tooLong = false;
}

void LineReader::takeLine(std::string_view line, std::vector<std::vector<double>>& readings) {
  if (m_skip) {
    m_skip = false;
    ++m_counts.banner;
    return;
  }
  auto parsed = m_tooLong ? std::unexpected(LineFault{LineProblem::TooLong, -1, std::string(line.substr(0, 40))})
                          : parseLine(m_format, line);
  m_tooLong = false;
  if (parsed) {
    ++m_counts.readings;
    readings.push_back(*std::move(parsed));
    return;
  }
  const LineProblem problem = parsed.error().problem;
  if (problem != LineProblem::Empty && problem != LineProblem::WrongPrefix) {
    ++(m_counts.readings == 0 ? m_counts.banner : m_counts.rejected);
    m_counts.notFinite += problem == LineProblem::NotFinite ? 1 : 0;
    m_lastFault = std::move(parsed.error());
  }
}

std::vector<std::vector<double>> LineReader::take(std::string_view bytes) {
  std::vector<std::vector<double>> readings;
  take(bytes, readings);
  return readings;
}

void LineReader::take(std::string_view bytes, std::vector<std::vector<double>>& readings) {
  while (!bytes.empty()) {
    const std::size_t end = bytes.find(m_end);
    const std::string_view part = bytes.substr(0, end);
    if (m_partial.size() + part.size() > longestLine) {
      m_tooLong = true; // keeps its front for the message, and no more however long it becomes
      m_partial.append(part.substr(0, longestLine - std::min(longestLine, m_partial.size())));
    } else if (end == std::string_view::npos || !m_partial.empty()) {
      m_partial += part;
    }
    if (end == std::string_view::npos) {
      break;
    }
    takeLine(m_partial.empty() ? part : std::string_view(m_partial), readings);
    m_partial.clear();
    bytes.remove_prefix(end + 1);
  }
}

} // namespace straightedge::devices
