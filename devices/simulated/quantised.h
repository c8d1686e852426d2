// Steps of simulated instruments.
#pragma once

#include <cmath>

namespace straightedge::devices {

/// The nearest multiple of `step`, 0 for none. Steps below 1 are fractions of a whole number, and dividing by that
/// gives the double that a decimal text of the instrument would: 109.2439, not 109.24390000000001.
inline double quantised(double value, double step) {
  if (!(step > 0.0)) {
    return value;
  }
  const double perUnit = step < 1.0 ? std::round(1.0 / step) : 1.0 / step;
  return std::round(value * perUnit) / perUnit + 0.0; // an instrument shows no −0, and a session keeps none
}

} // namespace straightedge::devices
