// SHA-256 of bytes: ties a result to the file it was computed from.
#pragma once

#include <string>
#include <string_view>

namespace straightedge {

/// 64 lower-case hex digits (FIPS 180-4). Any thread.
std::string sha256Hex(std::string_view bytes);

} // namespace straightedge
