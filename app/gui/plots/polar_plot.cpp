#include "app/gui/plots/polar_plot.h"

#include "app/gui/plots/plot_painting.h"
#include "app/gui/plots/theme.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace straightedge::gui {
namespace {

constexpr int labelledAngles = 8; ///< every 45°

QString angleLabel(int degrees) { return QString::number(degrees) + u'°'; }

void paintSeries(QPainter& painter, const PlotSeries& series, const PolarPlace& place, PlotTheme theme) {
  const QColor color = PlotColors::series(series.color, theme);
  const QColor paper = PlotColors::of(theme).background;
  const qsizetype count = std::min(series.x.size(), series.y.size());
  painter.setRenderHint(QPainter::Antialiasing, true);
  if (series.style == SeriesStyle::Bars) { // spokes
    painter.setPen(QPen(color, 2.0, Qt::SolidLine, Qt::FlatCap));
    for (qsizetype i = 0; i < count; ++i) {
      const QPointF end = place.toPixels(series.x[i], series.y[i]);
      if (std::isfinite(end.x()) && std::isfinite(end.y())) {
        painter.drawLine(place.center, end);
      }
    }
    return;
  }
  if (series.style != SeriesStyle::Points) {
    QPen pen(color, 1.7, series.dashed ? Qt::DashLine : Qt::SolidLine);
    painter.setPen(pen);
    QPolygonF run;
    for (qsizetype i = 0; i < count; ++i) {
      const QPointF p = place.toPixels(series.x[i], series.y[i]);
      if (std::isfinite(p.x()) && std::isfinite(p.y())) {
        run << p;
        continue;
      }
      painter.drawPolyline(run);
      run.clear();
    }
    painter.drawPolyline(run);
  }
  if (series.style == SeriesStyle::Line) {
    return;
  }
  // Neighbours on the ring stay apart.
  const double size = std::clamp(1.0 * place.radius / static_cast<double>(std::max<qsizetype>(count, 32)), 1.2, 3.2);
  for (qsizetype i = 0; i < count; ++i) {
    const QPointF p = place.toPixels(series.x[i], series.y[i]);
    if (!std::isfinite(p.x()) || !std::isfinite(p.y())) {
      continue;
    }
    const bool hollow = i < series.emphasised.size() && series.emphasised[i];
    painter.setPen(hollow ? QPen(color, 1.5) : QPen(Qt::NoPen));
    painter.setBrush(hollow ? paper : color);
    painter.drawEllipse(p, hollow ? size + 1.0 : size, hollow ? size + 1.0 : size);
  }
  painter.setBrush(Qt::NoBrush);
}

} // namespace

QPointF PolarPlace::toPixels(double angleDeg, double value) const {
  const double angle = angleDeg * std::numbers::pi / 180.0;
  const double r = radius * std::clamp((value - low) / (high - low), 0.0, 1.0);
  return center + r * QPointF(std::sin(angle), -std::cos(angle));
}

PolarPlace placePolar(const PlotSpec& spec, const PlotLayout& layout) {
  const QFontMetricsF metrics(PlotFonts::standard().label);
  const double across = metrics.horizontalAdvance(QStringLiteral("270°")) + 8.0;
  const double above = metrics.height() + 4.0;
  const QRectF inner = layout.plot.adjusted(across, above, -across, -above);
  PolarPlace place;
  place.center = inner.center();
  place.radius = std::max(8.0, 0.5 * std::min(inner.width(), inner.height()));
  double largest = 0.0;
  for (const PlotSeries& series : spec.series) {
    for (const double value : series.y) {
      largest = series.visible && std::isfinite(value) ? std::max(largest, value) : largest;
    }
  }
  place.low = spec.y.minimum.value_or(0.0);
  place.high = spec.y.maximum.value_or(largest > place.low ? place.low + 1.1 * (largest - place.low) : place.low + 1.0);
  if (!(place.high > place.low)) {
    place.high = place.low + 1.0;
  }
  return place;
}

void paintPolarPlot(QPainter& painter, const PlotSpec& spec, const PlotLayout& layout, PlotTheme theme) {
  const PlotColors colors = PlotColors::of(theme);
  const PolarPlace place = placePolar(spec, layout);
  const QFont font = PlotFonts::standard().label;
  const QFontMetricsF metrics(font);
  painter.setRenderHint(QPainter::Antialiasing, true);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colors.grid, 1.0));
  painter.drawEllipse(place.center, 0.5 * place.radius, 0.5 * place.radius);
  for (int i = 0; i < labelledAngles; ++i) {
    painter.drawLine(place.center, place.toPixels(45.0 * i, place.high));
  }
  painter.setPen(QPen(colors.axis, 1.0));
  painter.drawEllipse(place.center, place.radius, place.radius);
  const int step = place.radius < 60.0 ? 90 : 45;
  for (int angle = 0; angle < 360; angle += step) {
    const double radians = angle * std::numbers::pi / 180.0;
    const QPointF direction(std::sin(radians), -std::cos(radians));
    painter.setPen(QPen(colors.axis, 1.0));
    painter.drawLine(place.center + place.radius * direction, place.center + (place.radius + 4.0) * direction);
    const QSizeF size(metrics.horizontalAdvance(angleLabel(angle)) + 2.0, metrics.height());
    const QPointF away(direction.x() * (0.5 * size.width() + 7.0), direction.y() * (0.5 * size.height() + 6.0));
    const QPointF middle = place.center + place.radius * direction + away;
    painter.setFont(font);
    painter.setPen(colors.softText);
    painter.drawText(QRectF(middle - QPointF(0.5 * size.width(), 0.5 * size.height()), size),
                     Qt::AlignCenter | Qt::TextDontClip, angleLabel(angle));
  }
  for (const PlotSeries& series : spec.series) {
    if (series.visible) {
      paintSeries(painter, series, place, theme);
    }
  }
  paintFrameTexts(painter, spec, layout, theme);
}

} // namespace straightedge::gui
