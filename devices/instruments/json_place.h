// Where in a JSON text a value stands: nlohmann-json does not keep it, and whoever writes a file by hand needs the
// line.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace straightedge::devices {

/// Line, from 1, on which the value at `path` begins: keys of objects, numbers (as text) of list items. As far as the
/// path leads: the line of the last value that is there. `text` must be valid JSON.
int lineInJson(std::string_view text, std::span<const std::string> path);

} // namespace straightedge::devices
