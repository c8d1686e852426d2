// Which part of the data is looked at: the scales of the axes, found from the data or set by the user's zoom.
#pragma once

#include "app/gui/plots/axis_scale.h"
#include "app/gui/plots/plot_spec.h"

#include <QString>

namespace straightedge::gui {

struct PlotWindow {
  AxisScale x, y, right;

  const AxisScale& yOf(const PlotSeries& series) const { return series.rightAxis ? right : y; }
  /// The part between two corners in units of the axes; both y axes go together.
  PlotWindow part(double left, double bottom, double rightEdge, double top) const;

  bool operator==(const PlotWindow&) const = default;
};

/// The whole of the visible series with a margin of 5 %, fixed limits where the axes have them. Bars stand on 0.
/// Never empty, whatever the data (none, one point, all NaN, only values ≤ 0 on a logarithmic axis).
PlotWindow wholeWindow(const PlotSpec& spec);

/// Width of the bars of a series in data units of x: 80 % of the smallest distance between neighbours, shared by all
/// visible bar series; and where the series' bars start relative to x.
struct BarPlace {
  double width = 0.0;
  double offset = 0.0;
};
BarPlace barPlace(const PlotSpec& spec, int series);

/// Says how many values of visible series a logarithmic axis leaves out; empty if none.
QString leftOutNote(const PlotSpec& spec);

} // namespace straightedge::gui
