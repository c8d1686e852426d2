#include "app/gui/plots/axis_scale.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace straightedge::gui {

double AxisScale::toUnit(double value) const {
  if (!logarithmic) {
    return (value - minimum) / (maximum - minimum);
  }
  if (!(value > 0.0)) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const double low = std::log10(minimum);
  return (std::log10(value) - low) / (std::log10(maximum) - low);
}

double AxisScale::fromUnit(double unit) const {
  if (!logarithmic) {
    return minimum + unit * (maximum - minimum);
  }
  const double low = std::log10(minimum);
  return std::pow(10.0, low + unit * (std::log10(maximum) - low));
}

AxisScale AxisScale::part(double lower, double upper) const {
  AxisScale result{fromUnit(lower), fromUnit(upper), logarithmic};
  // Zooming ends where doubles can no longer tell neighbouring pixels apart, and before they overflow.
  const double size = std::max(std::abs(result.minimum), std::abs(result.maximum));
  const bool tooFine = !(result.maximum - result.minimum > size * 1e-12);
  const bool tooWide = !(size < 1e250) || (logarithmic && !(result.minimum > 1e-250));
  return tooFine || tooWide ? *this : result;
}

} // namespace straightedge::gui
