// Words that messages about angles share.
#pragma once

#include "core/angle/sweep.h"
#include "core/base/error.h"
#include "core/base/number_text.h"

#include <string>
#include <utility>

namespace straightedge::angle {

/// Three digits and the sign: for people, who take nothing from the digits of a rounding error.
inline std::string degreesText(double valueDeg) {
  constexpr double smallestDeg = 1e-6;
  if (valueDeg > 0.0 && valueDeg < smallestDeg) {
    return "less than 0.000001°";
  }
  return formatForPeople(valueDeg, 3) + "°";
}

/// The whole sweep is to blame, not one row.
inline Error sweepError(const Sweep& sweep, std::string what, std::string remedy) {
  return {ErrorKind::Input, std::move(what), std::move(remedy), sweep.source.file};
}

} // namespace straightedge::angle
