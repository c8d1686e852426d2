// From a million values to at most four per pixel column without changing the picture.
#pragma once

#include "app/gui/plots/axis_scale.h"

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace straightedge::gui {

/// A position on the plot in units of its axes (0 … 1 is visible).
struct UnitPoint {
  double x = 0.0;
  double y = 0.0;
};

/// Indices [first, last) of ascending x that can be seen between minimum and maximum, and one neighbour on either side.
std::pair<std::size_t, std::size_t> visibleRows(std::span<const double> x, double minimum, double maximum);

/// First, smallest, largest and last point of every run of neighbouring points that fall into the same of `columns`
/// pixel columns, in their order; all of them where there are few. A value that cannot be drawn (NaN, infinite, ≤ 0 on
/// a logarithmic axis) becomes one point of NaN and so stays a gap. `ascending` tells that x never decreases (then only
/// the visible rows are looked at). For x in any order the picture is right as well.
std::vector<UnitPoint> decimate(std::span<const double> x, std::span<const double> y, const AxisScale& xScale,
                                const AxisScale& yScale, int columns, bool ascending);

/// y[i] holds from x[i] to x[i + 1]: the corners of the staircase.
std::vector<UnitPoint> stepCorners(const std::vector<UnitPoint>& points);

/// Cuts a line at the border of the visible square widened by margins; gaps and cuts separate the runs. Painting far
/// outside is slow, and single precision would bend lines that come from far away.
std::vector<std::vector<UnitPoint>> clippedRuns(const std::vector<UnitPoint>& points, double marginX = 0.25,
                                                double marginY = 0.25);

/// At most one point per cell of a columns × rows grid over the visible square; indices of those kept.
std::vector<std::size_t> thinMarkers(std::span<const double> x, std::span<const double> y, const AxisScale& xScale,
                                     const AxisScale& yScale, int columns, int rows, bool ascending);

} // namespace straightedge::gui
