#include "app/cli/block_correction.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <cassert>
#include <cstring>

namespace straightedge::cli {

void CorrectedBlock::begin(std::size_t room) {
  if (bytes.size() < room) {
    bytes.resize(room);
  }
  used = 0;
  lines = 0;
  rows = 0;
  problem.reset();
}

void CorrectedBlock::add(std::string_view text) {
  assert(used + text.size() <= bytes.size());
  std::memcpy(bytes.data() + used, text.data(), text.size());
  used += text.size();
}

void CorrectedBlock::addNumber(double value, char decimalPoint) {
  assert(used + longestDoubleText <= bytes.size());
  char* const begin = bytes.data() + used;
  char* const end = formatDouble(value, begin);
  if (decimalPoint != '.') {
    std::replace(begin, end, '.', decimalPoint);
  }
  used += static_cast<std::size_t>(end - begin);
}

} // namespace straightedge::cli
