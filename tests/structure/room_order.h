// The order of rooms, and what breaks it: read from the #include lines.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace straightedge::structure {

struct Violation {
  std::string file;
  std::string include;
  std::string why;
};

/// What is wrong with one file's includes. `path` is relative to the root, e.g. "core/angle/curve.cpp".
std::vector<Violation> violationsIn(std::string_view path, std::string_view text);

} // namespace straightedge::structure
