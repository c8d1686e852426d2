// The magnet's field at the sensor: what angle an ideal sensor sees at a shaft angle.
#pragma once

namespace straightedge::devices {

/// Field vector while the shaft turns by u: (cos u + e·cos δ, (1 + k)·sin u + e·sin δ). The ellipse (k) comes from
/// unequal radial and tangential amplitudes beside a shaft and gives even harmonics of the angle error; the
/// displacement (e) comes from a magnet off the shaft's axis and gives the first; together they give the third and
/// higher ones. The sensor's angle rises with the shaft's as long as the origin lies inside the ellipse, which the
/// constructor sees to.
class FieldEllipse {
public:
  static constexpr double largestEllipticity = 2.0;
  static constexpr double largestDisplacement = 0.45;

  /// Values beyond the limits are brought to them. Angles in degrees.
  FieldEllipse(double ellipticity, double displacement, double mountingDeg);

  /// Angle of the field, counted from the sensor's zero: continuous, unwrapped, rising with `shaftDeg`.
  double fieldDeg(double shaftDeg) const;
  /// The inverse, to better than 1e-12 of a turn.
  double shaftDeg(double fieldDeg) const;

private:
  double deviationDeg(double shaftDeg) const;

  double m_ellipticity;
  double m_displacementX;
  double m_displacementY;
  double m_mountingDeg;
};

} // namespace straightedge::devices
