// Replies of a Group3 DTM-151.
#pragma once

#include <expected>
#include <string>
#include <string_view>

namespace straightedge::devices {

struct Dtm151Number {
  double value = 0.0;
  std::string unit; ///< "T", "G", "kG", "C", or empty
};

/// " 1.2345T", " -3.4E-02"; or the instrument's own error text ("OVER RANGE", "NO PROBE"), or "" where it is neither.
/// Source: Group3-Technology/group3lib protocol/parser.py.
std::expected<Dtm151Number, std::string> parseDtm151Number(std::string_view text);

} // namespace straightedge::devices
