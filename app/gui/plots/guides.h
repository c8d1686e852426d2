// Straight lines across a plot, e.g. a limit: painted with label and value, found under the pointer, dragged.
#pragma once

#include "app/gui/plots/plot_layout.h"
#include "app/gui/plots/plot_view.h"

class QPainter;

namespace straightedge::gui {

void paintGuides(QPainter& painter, const PlotSpec& spec, const PlotWindow& window, const PlotLayout& layout,
                 PlotTheme theme, int highlighted = -1);

/// "Target 0.5°"
QString guideText(const PlotGuide& guide, const PlotWindow& window);

/// Index of the draggable guide within `reach` logical pixels of `position`, −1 where there is none.
int guideAt(const PlotSpec& spec, const PlotWindow& window, const PlotLayout& layout, const QPointF& position,
            double reach = 5.0);

/// Value of a guide dragged to `position`: never beyond the visible range.
double draggedValue(const PlotGuide& guide, const PlotWindow& window, const PlotLayout& layout,
                    const QPointF& position);

} // namespace straightedge::gui
