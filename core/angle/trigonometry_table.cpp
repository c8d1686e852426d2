#include "core/angle/trigonometry_table.h"

#include <cmath>
#include <numbers>

namespace straightedge::angle {

TrigonometryTable::TrigonometryTable() {
  // One eighth of a turn is computed and mirrored: exact zeros, and symmetries that hold to the last bit.
  const double step = 2.0 * std::numbers::pi / static_cast<double>(size);
  const auto set = [this](std::size_t index, double value) { m_cosine[index % size] = value; };
  for (std::size_t i = 0; i <= size / 8; ++i) {
    const double c = std::cos(step * static_cast<double>(i));
    const double s = std::sin(step * static_cast<double>(i));
    set(i, c);
    set(size - i, c);
    set(size / 2 - i, -c);
    set(size / 2 + i, -c);
    set(size / 4 - i, s);
    set(3 * size / 4 + i, s);
    set(size / 4 + i, -s);
    set(3 * size / 4 - i, -s);
  }
}

const TrigonometryTable& TrigonometryTable::instance() {
  static const TrigonometryTable table;
  return table;
}

} // namespace straightedge::angle
