// A ring of angles, 0° at the top and clockwise: which part of the turn has been measured.
#pragma once

#include "app/gui/plots/plot_layout.h"
#include "app/gui/plots/plot_view.h"

class QPainter;

namespace straightedge::gui {

/// Where the ring is and what radius means: y's range (fixed, or 0 to the largest value) from center to outer circle.
struct PolarPlace {
  QPointF center;
  double radius = 0.0; ///< of the outer circle, pixels
  double low = 0.0;    ///< y at the center
  double high = 1.0;   ///< y on the outer circle

  QPointF toPixels(double angleDeg, double value) const;
};

PolarPlace placePolar(const PlotSpec& spec, const PlotLayout& layout);

void paintPolarPlot(QPainter& painter, const PlotSpec& spec, const PlotLayout& layout, PlotTheme theme);

} // namespace straightedge::gui
