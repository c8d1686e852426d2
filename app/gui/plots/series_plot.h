// One series on a vtkChartXY: takes prepared coordinates in units of the axes and only strokes them. vtkPlotLine and
// its kin keep tables and caches of their own, which is where their trouble with NaN, log axes and a million points is
// from.
#pragma once

#include "app/gui/plots/plot_spec.h"
#include "app/gui/plots/plot_window.h"
#include "app/gui/plots/theme.h"

#include <QColor>
#include <QSizeF>
#include <vtkPlot.h>

#include <array>
#include <vector>

namespace straightedge::gui {

/// What remains of a series to be painted: x, y pairs in units of the axes.
struct SeriesGeometry {
  std::vector<std::vector<float>> lines;
  std::vector<float> markers;              ///< filled
  std::vector<float> hollow;               ///< emphasised points
  std::vector<std::array<float, 8>> bars;  ///< four corners each
  std::vector<std::array<float, 8>> faint; ///< bars that stand back behind emphasised ones
  float markerSize = 6.0F;
};

/// `pixels`: size of the plot area in device pixels, to which the data are thinned.
SeriesGeometry prepareSeries(const PlotSpec& spec, int index, const PlotWindow& window, const QSizeF& pixels,
                             double devicePixelRatio);

class SeriesPlot : public vtkPlot {
public:
  static SeriesPlot* New();
  SeriesPlot(const SeriesPlot&) = delete;
  SeriesPlot& operator=(const SeriesPlot&) = delete;

  void show(SeriesGeometry geometry, const QColor& color, MarkerShape shape, bool dashed, float lineWidth);
  bool Paint(vtkContext2D* painter) override;
  void GetBounds(double bounds[4]) override;

vtkTypeMacro(SeriesPlot, vtkPlot)

    protected : SeriesPlot() = default;
  ~SeriesPlot() override = default;

private:
  SeriesGeometry m_geometry;
  QColor m_color;
  MarkerShape m_shape = MarkerShape::Circle;
  bool m_dashed = false;
  float m_lineWidth = 1.5F;
};

} // namespace straightedge::gui
