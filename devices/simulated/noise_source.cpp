#include "devices/simulated/noise_source.h"

#include <cmath>

namespace straightedge::devices {

double NoiseSource::uniform() {
  constexpr double steps = 4503599627370496.0; // 2^52
  return (static_cast<double>(m_generator() >> 11U) + 0.5) / steps - 1.0;
}

double NoiseSource::standardNormal() {
  if (m_hasSpare) {
    m_hasSpare = false;
    return m_spare;
  }
  double u = 0.0;
  double v = 0.0;
  double square = 0.0;
  do {
    u = uniform();
    v = uniform();
    square = u * u + v * v;
  } while (square >= 1.0 || square == 0.0);
  const double scale = std::sqrt(-2.0 * std::log(square) / square);
  m_spare = v * scale;
  m_hasSpare = true;
  return u * scale;
}

} // namespace straightedge::devices
