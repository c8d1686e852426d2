// Is this CSV text at all? Refuses what only looks like a CSV file, with one clear message each.
#pragma once

#include "core/base/error.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace straightedge {

/// No row of a measured table is longer; a longer one means that the file is something else.
inline constexpr std::size_t longestCsvLine = std::size_t{1} << 20U;

/// Length of a UTF-8 byte-order mark at the start of `bytes`: 3 or 0.
std::size_t byteOrderMarkLength(std::string_view bytes);

/// Checks the start of an input of which the rest may still be to come.
/// Errors (Input, where = name): empty; UTF-16 or UTF-32; a spreadsheet or an archive; binary (NUL or control bytes).
Result<void> checkCsvText(std::string_view bytes, const std::string& name);

/// Bytes that no text has: NUL and most other control characters.
bool hasControlBytes(std::string_view bytes);

/// `bytes` as text: byte-order mark removed, lines ended by LF or CRLF (a file with nothing but CR is converted).
/// Errors: those of checkCsvText().
Result<std::string> csvText(std::string bytes, const std::string& name);

} // namespace straightedge
