// Which point is meant by a place on the plot: the nearest one of all, found in the data's own doubles.
#pragma once

#include "app/gui/plots/plot_layout.h"

#include <QList>

namespace straightedge::gui {

struct PickedPoint {
  int series = -1; ///< −1: nothing near
  int index = -1;
  QPointF pixels;

  explicit operator bool() const { return series >= 0; }
};

/// Reach of the pointer in logical pixels, whatever the screen's resolution.
constexpr double pickReach = 18.0;

/// The visible point nearest to `position`, at most `reach` pixels away; bars are met anywhere on the bar's column.
/// Where two are equally near, the series painted later (on top) wins.
PickedPoint nearestPoint(const PlotSpec& spec, const PlotWindow& window, const PlotLayout& layout,
                         const QPointF& position, double reach = pickReach);

/// Indices of a visible series' points inside a rectangle of pixels.
QList<int> pointsWithin(const PlotSpec& spec, int series, const PlotWindow& window, const PlotLayout& layout,
                        const QRectF& pixels);

/// The neighbour of a point in the direction of x (−1, +1) that can be shown; `from` itself where there is none.
PickedPoint neighbour(const PlotSpec& spec, const PlotWindow& window, const PlotLayout& layout, const PickedPoint& from,
                      int direction);

/// Lines of the hover text: label of the point, series, x and y with their units.
QStringList hoverLines(const PlotSpec& spec, const PlotWindow& window, const PickedPoint& point);

} // namespace straightedge::gui
