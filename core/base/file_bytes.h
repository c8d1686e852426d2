// Whole files, and standard input, into memory.
#pragma once

#include "core/base/error.h"

#include <cstddef>
#include <string>

namespace straightedge {

/// Cells of longer files could not be counted in 32 bits, and nobody measures as much: refused.
inline constexpr std::size_t longestInput = std::size_t{2} << 30U;

/// The name under which messages speak of an input: the path as it was given, or "standard input" for "-".
std::string inputName(const std::string& path);

/// File name without folder, for SourceRecord; "standard input" for "-".
std::string inputFileName(const std::string& path);

/// All bytes of the file at `path`, or of standard input if `path` is "-". Any thread.
/// Errors (Input): not there, a folder, not readable, longer than 2 GiB; `where` is inputName().
Result<std::string> readFileBytes(const std::string& path);

} // namespace straightedge
