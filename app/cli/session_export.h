// Raw samples of a session as a CSV file.
#pragma once

#include "core/base/error.h"

#include <string>

namespace straightedge::cli {

/// Writes the calibration sweep or campaign of a session file as the CSV that `angle fit` and `field fit` read.
/// `out` is a file or "-". Errors: Usage for another format than "csv"; those of reading the session and of writing.
Result<void> exportSession(const std::string& session, const std::string& format, const std::string& out);

} // namespace straightedge::cli
