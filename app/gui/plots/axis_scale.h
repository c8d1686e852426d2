// Where a value lies on an axis: data units <-> 0 … 1 along the axis, linear or logarithmic.
#pragma once

namespace straightedge::gui {

/// minimum < maximum, both finite, both > 0 on a logarithmic axis. All drawing happens in these 0 … 1 units, so that
/// single-precision coordinates resolve a pixel whatever the offset of the data (epoch seconds, 1 + 1e-9).
struct AxisScale {
  double minimum = 0.0;
  double maximum = 1.0;
  bool logarithmic = false;

  /// 0 at minimum, 1 at maximum; NaN for NaN and for values ≤ 0 on a logarithmic axis.
  double toUnit(double value) const;
  double fromUnit(double unit) const;
  double span() const { return maximum - minimum; }
  /// The part of this axis between two positions in units; stays valid (positive span, finite).
  AxisScale part(double lower, double upper) const;

  bool operator==(const AxisScale&) const = default;
};

} // namespace straightedge::gui
