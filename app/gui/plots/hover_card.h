// What lies on top of a plot on the screen only: marked point with its values, rubber band, magnifier.
#pragma once

#include "app/gui/plots/picking.h"
#include "app/gui/plots/plot_view.h"

class QPainter;

namespace straightedge::gui {

class ChartScene;

/// Ring around the point and a card with `lines` beside it, inside `bounds`.
void paintHoverCard(QPainter& painter, const QPointF& point, const QStringList& lines, const QRectF& bounds,
                    const QColor& seriesColor, PlotTheme theme);

void paintRubberBand(QPainter& painter, const QRectF& band, PlotTheme theme);

/// A lens beside `position` (inside the plot) that paints the data around it anew, eight times larger.
void paintMagnifier(QPainter& painter, ChartScene& scene, const PlotSpec& spec, const PlotWindow& window,
                    const PlotLayout& layout, const QPointF& position, PlotTheme theme);

} // namespace straightedge::gui
