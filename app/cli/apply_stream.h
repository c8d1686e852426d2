// A table of readings corrected as it flows by: blocks in several threads, results in order, memory bounded.
#pragma once

#include "app/cli/block_correction.h"
#include "core/base/error.h"

#include <cstddef>
#include <string>

namespace straightedge::cli {

struct ApplyReport {
  std::size_t rows = 0;
  std::size_t bytesRead = 0;
};

/// Reads CSV from `input` ("-": standard input), adds what the correction adds and writes to `output` ("-": standard
/// output; otherwise a file that appears whole or not at all). `threads` work beside the calling one.
/// Errors: those of `make`; Input with FILE:LINE of the first row that cannot be corrected; Storage.
Result<ApplyReport> applyToReadings(const std::string& input, const std::string& output, const MakeCorrection& make,
                                    unsigned threads);

} // namespace straightedge::cli
