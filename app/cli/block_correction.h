// How a stream of readings is corrected: block by block, every row gets further cells, everything else passes through.
#pragma once

#include "core/base/error.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace straightedge::cli {

/// Grows as needed and keeps its memory from block to block.
struct CorrectedBlock {
  std::vector<char> bytes; ///< only the first `used` count
  std::size_t used = 0;
  std::size_t lines = 0; ///< of the input, up to the problem if there is one
  std::size_t rows = 0;
  std::optional<Error> problem; ///< its place is the last of `lines`

  std::string_view text() const { return {bytes.data(), used}; }
  /// Empty again, with room for so many bytes.
  void begin(std::size_t room);
  /// There is room, for a number longestDoubleText.
  void add(std::string_view text);
  void addNumber(double value, char decimalPoint);
  void blame(std::string what, std::string remedy) {
    problem = Error{ErrorKind::Input, std::move(what), std::move(remedy), {}};
  }
};

/// What all blocks of a stream share. Immutable while blocks are worked on.
class BlockCorrection {
public:
  BlockCorrection() = default;
  virtual ~BlockCorrection() = default;
  BlockCorrection(const BlockCorrection&) = delete;
  BlockCorrection& operator=(const BlockCorrection&) = delete;

  /// `block`: whole lines. `first`: the stream's first block, which holds a byte-order mark and the header if there are
  /// any. Any thread; blocks may be corrected at the same time.
  virtual void correct(std::string_view block, bool first, CorrectedBlock& result) const = 0;
};

/// Made when the start of the readings has been seen: `start` ends at the end of a line or of the file.
/// Errors (Input, where = name): the readings lack what the correction needs.
using MakeCorrection =
    std::function<Result<std::unique_ptr<const BlockCorrection>>(std::string_view start, const std::string& name)>;

} // namespace straightedge::cli
