// Paints a whole plot: frame, chart, text, legend, guides. The screen, pictures and files all come through here.
#pragma once

#include "app/gui/plots/chart_scene.h"
#include "app/gui/plots/plot_layout.h"
#include "app/gui/plots/plot_view.h"

class QPainter;

namespace straightedge::gui {

/// Guides are left out here where the screen paints them on top, so that dragging does not repaint the data.
enum class GuidePainting : std::uint8_t { Include, LeaveOut };

void paintFrame(QPainter& painter, ChartScene& scene, const PlotSpec& spec, const PlotWindow& window,
                const PlotLayout& layout, PlotTheme theme, GuidePainting guides);

/// Titles, legend and note, for every kind of plot.
void paintFrameTexts(QPainter& painter, const PlotSpec& spec, const PlotLayout& layout, PlotTheme theme);

} // namespace straightedge::gui
