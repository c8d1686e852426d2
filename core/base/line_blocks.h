// A long text in blocks that end where lines end, so that blocks can be worked on apart.
#pragma once

#include "core/base/error.h"
#include "core/base/input_file.h"

#include <cstddef>
#include <string>

namespace straightedge {

/// One thread. Memory: a block and the longest line.
class LineBlocks {
public:
  explicit LineBlocks(InputFile file, std::size_t blockSize = std::size_t{256} * 1024)
      : m_file(std::move(file)), m_blockSize(blockSize) {}

  /// Replaces `block` by the next whole lines (the last one may lack its newline); false at the end.
  /// `atLeast`: goes on reading until the block has so many bytes, for looking at the start of a file. Otherwise a
  /// pipe's bytes are handed on as they come. Errors: those of InputFile. A line longer than longestCsvLine ends a
  /// block early, without a newline: tooLong() is true then.
  Result<bool> next(std::string& block, std::size_t atLeast = 1);

  bool tooLong() const { return m_tooLong; }
  bool hasBytesReady() const { return m_file.hasBytesReady(); }

private:
  InputFile m_file;
  std::size_t m_blockSize;
  std::string m_rest; ///< begin of a line whose end has not come yet
  bool m_ended = false;
  bool m_tooLong = false;
};

} // namespace straightedge
