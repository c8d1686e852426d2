#include "core/base/line_blocks.h"

#include "core/base/csv_text.h"

namespace straightedge {

Result<bool> LineBlocks::next(std::string& block, std::size_t atLeast) {
  block.swap(m_rest);
  m_rest.clear();
  while (!m_ended) {
    const std::size_t used = block.size();
    Result<std::size_t> count = 0;
    block.resize_and_overwrite(used + m_blockSize, [&](char* bytes, std::size_t) {
      count = m_file.read(bytes + used, m_blockSize);
      return used + count.value_or(0);
    });
    if (!count) {
      return std::unexpected(count.error());
    }
    m_ended = *count == 0;
    const auto newline = block.find_last_of('\n');
    if (!m_ended && newline != std::string::npos && block.size() >= atLeast) {
      m_rest.assign(block, newline + 1);
      block.resize(newline + 1);
      return true;
    }
    if (newline == std::string::npos) {
      m_tooLong = block.size() > longestCsvLine;
      if (m_tooLong) {
        m_ended = true;
        return true;
      }
    }
  }
  return !block.empty();
}

} // namespace straightedge
