#include "app/gui/plots/series_plot.h"

#include "app/gui/plots/decimation.h"
#include "app/gui/plots/painter_device.h"

#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkPen.h>

#include <algorithm>
#include <cmath>

namespace straightedge::gui {
namespace {

std::span<const double> view(const QList<double>& values) {
  return {values.constData(), static_cast<std::size_t>(values.size())};
}

bool isAscending(std::span<const double> x) {
  if (!x.empty() && std::isnan(x.front())) {
    return false;
  }
  const auto falls = [](double before, double after) { return !(after >= before); }; // also where one is NaN
  return std::adjacent_find(x.begin(), x.end(), falls) == x.end();
}

void append(std::vector<float>& to, double x, double y) {
  to.push_back(static_cast<float>(x));
  to.push_back(static_cast<float>(y));
}

bool emphasised(const PlotSeries& series, std::size_t row) {
  return static_cast<qsizetype>(row) < series.emphasised.size() && series.emphasised[static_cast<qsizetype>(row)];
}

void prepareBars(SeriesGeometry& out, const PlotSpec& spec, int index, const PlotWindow& window, double minimumWidth) {
  const PlotSeries& series = spec.series[index];
  const AxisScale& yScale = window.yOf(series);
  const BarPlace place = barPlace(spec, index);
  const bool someEmphasised = series.emphasised.contains(true);
  const double base = yScale.logarithmic ? 0.0 : std::clamp(yScale.toUnit(0.0), 0.0, 1.0);
  for (qsizetype i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
    double left = window.x.toUnit(series.x[i] + place.offset);
    double right = window.x.toUnit(series.x[i] + place.offset + place.width);
    const double y = yScale.toUnit(series.y[i]);
    if (!std::isfinite(left) || !std::isfinite(right) || !std::isfinite(y) || right < 0.0 || left > 1.0) {
      continue;
    }
    if (right - left < minimumWidth) {
      const double middle = 0.5 * (left + right);
      left = middle - 0.5 * minimumWidth;
      right = middle + 0.5 * minimumWidth;
    }
    const auto l = static_cast<float>(std::max(left, 0.0));
    const auto r = static_cast<float>(std::min(right, 1.0));
    const auto b = static_cast<float>(base);
    const auto t = static_cast<float>(std::clamp(y, 0.0, 1.0));
    const bool standsBack = someEmphasised && !emphasised(series, static_cast<std::size_t>(i));
    (standsBack ? out.faint : out.bars).push_back({l, b, r, b, r, t, l, t});
  }
}

void prepareMarkers(SeriesGeometry& out, const PlotSeries& series, const PlotWindow& window, const QSizeF& pixels,
                    double devicePixelRatio) {
  const bool marked = series.style == SeriesStyle::Points || series.style == SeriesStyle::LineAndPoints;
  if (!marked && series.emphasised.isEmpty()) {
    return;
  }
  const auto x = view(series.x);
  const auto y = view(series.y);
  const AxisScale& yScale = window.yOf(series);
  const bool ascending = isAscending(x);
  const auto place = [&](std::vector<float>& to, std::size_t row) {
    append(to, window.x.toUnit(x[row]), yScale.toUnit(y[row]));
  };
  if (marked) {
    // One marker per logical half pixel at most, coarser where they would only paint over each other.
    const double cell = x.size() > 20000 ? 1.5 : 0.5;
    const double size = devicePixelRatio * cell;
    const auto rows = thinMarkers(x, y, window.x, yScale, static_cast<int>(pixels.width() / size),
                                  static_cast<int>(pixels.height() / size), ascending);
    const double room = pixels.width() / devicePixelRatio;
    const bool crowded = static_cast<double>(rows.size()) > room;
    out.markerSize = crowded ? 3.5F : 6.5F;
    const bool lineAlone = series.style == SeriesStyle::LineAndPoints && static_cast<double>(rows.size()) > room / 4.0;
    if (!lineAlone) {
      for (const std::size_t row : rows) {
        if (!emphasised(series, row)) {
          place(out.markers, row);
        }
      }
    }
  }
  for (std::size_t row = 0; row < std::min(x.size(), static_cast<std::size_t>(series.emphasised.size())); ++row) {
    if (row < y.size() && emphasised(series, row)) {
      const double u = window.x.toUnit(x[row]);
      const double v = yScale.toUnit(y[row]);
      if (u >= -0.01 && u <= 1.01 && v >= -0.01 && v <= 1.01) {
        place(out.hollow, row);
      }
    }
  }
}

} // namespace

SeriesGeometry prepareSeries(const PlotSpec& spec, int index, const PlotWindow& window, const QSizeF& pixels,
                             double devicePixelRatio) {
  const PlotSeries& series = spec.series[index];
  SeriesGeometry out;
  if (series.style == SeriesStyle::Bars) {
    prepareBars(out, spec, index, window, devicePixelRatio / std::max(1.0, pixels.width()));
    return out;
  }
  if (series.style != SeriesStyle::Points) {
    const auto x = view(series.x);
    auto points = decimate(x, view(series.y), window.x, window.yOf(series),
                           std::max(1, static_cast<int>(pixels.width())), isAscending(x));
    if (series.style == SeriesStyle::Steps) {
      points = stepCorners(points);
    }
    // One pixel beyond the border, where the plot is clipped only coarsely for the sake of markers on the border.
    const double logical = devicePixelRatio;
    for (const auto& run :
         clippedRuns(points, logical / std::max(1.0, pixels.width()), logical / std::max(1.0, pixels.height()))) {
      if (run.size() == 1) { // a point between two gaps has no line
        append(out.markers, run.front().x, run.front().y);
        out.markerSize = 3.0F;
        continue;
      }
      std::vector<float> line;
      line.reserve(run.size() * 2);
      for (const UnitPoint& p : run) {
        append(line, p.x, p.y);
      }
      out.lines.push_back(std::move(line));
    }
  }
  prepareMarkers(out, series, window, pixels, devicePixelRatio);
  return out;
}

SeriesPlot* SeriesPlot::New() {
  auto* plot = new SeriesPlot;
  plot->InitializeObjectBase();
  return plot;
}

void SeriesPlot::show(SeriesGeometry geometry, const QColor& color, MarkerShape shape, bool dashed, float lineWidth) {
  m_geometry = std::move(geometry);
  m_color = color;
  m_shape = shape;
  m_dashed = dashed;
  m_lineWidth = lineWidth;
}

void SeriesPlot::GetBounds(double bounds[4]) {
  bounds[0] = bounds[2] = 0.0;
  bounds[1] = bounds[3] = 1.0;
}

bool SeriesPlot::Paint(vtkContext2D* painter) {
  vtkPen* pen = painter->GetPen();
  const auto red = static_cast<unsigned char>(m_color.red());
  const auto green = static_cast<unsigned char>(m_color.green());
  const auto blue = static_cast<unsigned char>(m_color.blue());
  pen->SetColor(red, green, blue, 255);
  pen->SetLineType(vtkPen::SOLID_LINE);
  painter->GetBrush()->SetColor(red, green, blue, 225);
  for (auto& bar : m_geometry.bars) {
    painter->DrawQuad(bar.data());
  }
  painter->GetBrush()->SetColor(red, green, blue, 105);
  for (auto& bar : m_geometry.faint) {
    painter->DrawQuad(bar.data());
  }
  pen->SetWidth(m_lineWidth);
  pen->SetLineType(m_dashed ? vtkPen::DASH_LINE : vtkPen::SOLID_LINE);
  for (auto& line : m_geometry.lines) {
    painter->DrawPoly(line.data(), static_cast<int>(line.size() / 2));
  }
  pen->SetLineType(vtkPen::SOLID_LINE);
  const auto drawMarkers = [&](std::vector<float>& at, float size, bool hollow) {
    if (at.empty()) {
      return;
    }
    int shape = VTK_MARKER_CIRCLE;
    switch (m_shape) {
    case MarkerShape::Square:
      shape = VTK_MARKER_SQUARE;
      break;
    case MarkerShape::Diamond:
      shape = VTK_MARKER_DIAMOND;
      break;
    case MarkerShape::Triangle:
      shape = PainterDevice::triangleMarker;
      break;
    case MarkerShape::Cross:
      shape = VTK_MARKER_CROSS;
      break;
    case MarkerShape::Plus:
      shape = VTK_MARKER_PLUS;
      break;
    default:
      break;
    }
    pen->SetWidth(size);
    painter->DrawMarkers(hollow ? VTK_MARKER_CIRCLE : shape, hollow, at.data(), static_cast<int>(at.size() / 2));
  };
  drawMarkers(m_geometry.markers, m_geometry.markerSize, false);
  drawMarkers(m_geometry.hollow, m_geometry.markerSize + 3.0F, true);
  return true;
}

} // namespace straightedge::gui
