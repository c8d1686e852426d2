#include "devices/simulated/field_geometry.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace straightedge::devices {

namespace {

constexpr double radPerDeg = std::numbers::pi / 180.0;
/// Direction of the displacement: neither along an axis of the ellipse nor across, so that all phases occur.
constexpr double displacementDirectionRad = 0.7;

} // namespace

FieldEllipse::FieldEllipse(double ellipticity, double displacement, double mountingDeg)
    : m_ellipticity(std::clamp(ellipticity, -0.5, largestEllipticity)), m_mountingDeg(mountingDeg) {
  const double e = std::clamp(displacement, -largestDisplacement, largestDisplacement);
  m_displacementX = e * std::cos(displacementDirectionRad);
  m_displacementY = e * std::sin(displacementDirectionRad);
}

double FieldEllipse::deviationDeg(double shaftDeg) const {
  const double u = std::remainder(shaftDeg, 360.0) * radPerDeg;
  const double cosU = std::cos(u);
  const double sinU = std::sin(u);
  const double x = cosU + m_displacementX;
  const double y = (1.0 + m_ellipticity) * sinU + m_displacementY;
  // The field seen from a frame that turns with the shaft: small, hence never at the seam of atan2.
  return std::atan2(y * cosU - x * sinU, x * cosU + y * sinU) / radPerDeg;
}

double FieldEllipse::fieldDeg(double shaftDeg) const { return shaftDeg - m_mountingDeg + deviationDeg(shaftDeg); }

double FieldEllipse::shaftDeg(double fieldDeg) const {
  double low = fieldDeg + m_mountingDeg - 120.0;
  double high = low + 240.0;
  // Halving until neighbouring doubles: rising, so it cannot go astray, and it is not called in any inner loop.
  for (int i = 0; i < 80; ++i) {
    const double middle = std::midpoint(low, high);
    if (middle <= low || middle >= high) {
      break;
    }
    (this->fieldDeg(middle) < fieldDeg ? low : high) = middle;
  }
  return std::midpoint(low, high);
}

} // namespace straightedge::devices
