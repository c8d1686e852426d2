// Cosine and sine of i·360/4096, exact to the last bit of the library's cos: computed once, never changed.
#pragma once

#include "core/angle/curve.h"

#include <array>
#include <complex>
#include <cstddef>

namespace straightedge::angle {

class TrigonometryTable {
public:
  /// The one table. Thread-safe: built at the first call.
  static const TrigonometryTable& instance();

  /// step is taken modulo 4096
  double cosine(std::size_t step) const { return m_cosine[step % size]; }
  double sine(std::size_t step) const { return m_cosine[(step + 3 * size / 4) % size]; }
  std::complex<double> unit(std::size_t step) const { return {cosine(step), sine(step)}; }

private:
  static constexpr std::size_t size = gridSize;
  TrigonometryTable();
  std::array<double, size> m_cosine{};
};

} // namespace straightedge::angle
