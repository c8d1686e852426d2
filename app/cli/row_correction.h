// One block of a table of readings corrected: every row gets a further cell, everything else passes through.
#pragma once

#include "app/cli/reading_layout.h"
#include "core/angle/model.h"
#include "core/base/error.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace straightedge::cli {

/// What all blocks of a stream share. Immutable while blocks are worked on.
struct RowCorrection {
  ReadingLayout layout;
  angle::Model model;
  angle::SensorDirection direction = angle::SensorDirection::Increasing;
};

/// Grows as needed and keeps its memory from block to block.
struct CorrectedBlock {
  std::vector<char> bytes; ///< only the first `used` count
  std::size_t used = 0;
  std::size_t lines = 0; ///< of the input, up to the problem if there is one
  std::size_t rows = 0;
  std::optional<Error> problem; ///< its place is the last of `lines`

  std::string_view text() const { return {bytes.data(), used}; }
};

/// `block`: whole lines. `first`: the stream's first block, which holds a byte-order mark and the header if there are
/// any. Any thread; blocks may be corrected at the same time.
void correctRows(const RowCorrection& correction, std::string_view block, bool first, CorrectedBlock& result);

} // namespace straightedge::cli
