#include "app/gui/plots/chart_scene.h"

#include "app/gui/plots/painter_device.h"
#include "app/gui/plots/series_plot.h"
#include "app/gui/plots/theme.h"
#include "app/gui/plots/vtk_messages.h"

#include <QPainter>
#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkChartXY.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace straightedge::gui {
namespace {

void colorPen(vtkPen* pen, const QColor& color, float width) {
  pen->SetColor(static_cast<unsigned char>(color.red()), static_cast<unsigned char>(color.green()),
                static_cast<unsigned char>(color.blue()), static_cast<unsigned char>(color.alpha()));
  pen->SetWidth(width);
}

void showTicks(vtkAxis* axis, const Ticks& ticks, const AxisScale& scale) {
  vtkNew<vtkDoubleArray> positions;
  vtkNew<vtkStringArray> labels;
  for (const double position : ticks.positions) {
    positions->InsertNextValue(std::clamp(scale.toUnit(position), 0.0, 1.0));
    labels->InsertNextValue("");
  }
  axis->SetCustomTickPositions(positions, labels);
}

double deviceScale(const QPainter& painter) {
  const QTransform device = painter.deviceTransform();
  return std::clamp(std::hypot(device.m11(), device.m12()), 1.0, 4.0);
}

} // namespace

struct ChartScene::Impl {
  vtkNew<vtkContextScene> scene;
  vtkNew<vtkChartXY> chart;
  std::vector<vtkSmartPointer<SeriesPlot>> plots;

  Impl() {
    sendVtkMessagesToLog();
    chart->SetRenderEmpty(true);
    chart->SetLayoutStrategy(vtkChart::AXES_TO_RECT);
    chart->SetAutoAxes(false);
    chart->SetShowLegend(false);
    chart->GetBackgroundBrush()->SetColorF(0.0, 0.0, 0.0, 0.0);
    for (int i = 0; i < 4; ++i) {
      vtkAxis* axis = chart->GetAxis(i);
      axis->SetBehavior(vtkAxis::FIXED);
      axis->SetRange(0.0, 1.0);
      axis->SetLabelsVisible(false);
      axis->SetTitle("");
      axis->SetTickLength(5.0F);
      axis->SetVisible(i != vtkAxis::TOP);
    }
    scene->AddItem(chart);
  }
};

ChartScene::ChartScene() : m_impl(std::make_unique<Impl>()) {}
ChartScene::~ChartScene() = default;

void ChartScene::paint(QPainter& painter, const PlotSpec& spec, const PlotWindow& window, const PlotLayout& layout,
                       PlotTheme theme) {
  const PlotColors colors = PlotColors::of(theme);
  vtkChartXY* chart = m_impl->chart;
  const double scale = deviceScale(painter);

  chart->ClearPlots();
  m_impl->plots.clear();
  for (int index = 0; index < spec.series.size(); ++index) {
    const PlotSeries& series = spec.series[index];
    if (!series.visible) {
      continue;
    }
    auto plot = vtkSmartPointer<SeriesPlot>::New();
    plot->show(prepareSeries(spec, index, window, layout.plot.size() * scale, scale),
               PlotColors::series(series.color, theme), markerOf(series.color), series.dashed,
               series.style == SeriesStyle::LineAndPoints ? 1.3F : 1.7F);
    chart->AddPlot(plot);
    m_impl->plots.push_back(plot);
  }

  const std::array<const Ticks*, 3> ticks = {&layout.yTicks, &layout.xTicks, &layout.rightTicks};
  const std::array<const AxisScale*, 3> scales = {&window.y, &window.x, &window.right};
  for (std::size_t i = 0; i < 3; ++i) { // vtkAxis::LEFT, BOTTOM, RIGHT
    vtkAxis* axis = chart->GetAxis(static_cast<int>(i));
    showTicks(axis, *ticks[i], *scales[i]);
    axis->SetGridVisible(i != vtkAxis::RIGHT);
    colorPen(axis->GetGridPen(), colors.grid, 1.0F);
    colorPen(axis->GetPen(), colors.axis, 1.0F);
  }
  chart->GetAxis(vtkAxis::RIGHT)->SetVisible(spec.right.has_value());

  // VTK measures from the lower left corner of the whole area.
  const QRectF place = layout.plot.translated(-layout.area.topLeft());
  const int width = static_cast<int>(std::ceil(layout.area.width()));
  const int height = static_cast<int>(std::ceil(layout.area.height()));
  chart->SetSize(vtkRectf(static_cast<float>(place.left()), static_cast<float>(height - place.bottom()),
                          static_cast<float>(place.width()), static_cast<float>(place.height())));
  painter.save();
  painter.translate(layout.area.topLeft());
  PainterDevice::paintScene(*m_impl->scene, painter, width, height, colors.background);
  painter.restore();
}

} // namespace straightedge::gui
