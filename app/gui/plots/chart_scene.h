// A PlotSpec as a vtkChartXY on a painter: grid, axes and series. Text is laid out and painted by us.
#pragma once

#include "app/gui/plots/plot_layout.h"
#include "app/gui/plots/plot_view.h"

#include <memory>

class QPainter;

namespace straightedge::gui {

/// Keeps its VTK objects from paint to paint. One thread at a time; scenes in several threads are independent.
/// The chart only ever sees axes of 0 … 1: logarithms, offsets, fixed ranges and what to leave out are settled before,
/// which is the cure for vtkChartXY's silent switch to linear, empty first paint and six-digit labels.
class ChartScene {
public:
  ChartScene();
  ~ChartScene();
  ChartScene(const ChartScene&) = delete;
  ChartScene& operator=(const ChartScene&) = delete;

  void paint(QPainter& painter, const PlotSpec& spec, const PlotWindow& window, const PlotLayout& layout,
             PlotTheme theme);

private:
  struct Impl;
  std::unique_ptr<Impl> m_impl;
};

} // namespace straightedge::gui
