// Angles in degrees and how they wrap.
#pragma once

#include <cmath>

namespace straightedge::angle {

/// `deg` wrapped to [0, 360). Exactly 360, and tiny negatives that round up to it, give 0.
inline double wrap360(double deg) {
  double wrapped = std::fmod(deg, 360.0);
  if (wrapped < 0.0) {
    wrapped += 360.0;
  }
  return wrapped >= 360.0 ? 0.0 : wrapped;
}

/// `deg` wrapped to [-180, 180): the form in which angle errors are stated.
inline double wrap180(double deg) {
  const double wrapped = wrap360(deg + 180.0) - 180.0;
  return wrapped;
}

} // namespace straightedge::angle
