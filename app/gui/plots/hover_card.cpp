#include "app/gui/plots/hover_card.h"

#include "app/gui/plots/chart_scene.h"
#include "app/gui/plots/theme.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace straightedge::gui {
namespace {

constexpr double lensZoom = 8.0;

/// Beside `point`, flipped to the other side where it would leave `bounds`.
QRectF beside(const QPointF& point, const QSizeF& size, const QRectF& bounds, double gap) {
  QRectF place(point + QPointF(gap, gap), size);
  if (place.right() > bounds.right()) {
    place.moveRight(point.x() - gap);
  }
  if (place.bottom() > bounds.bottom()) {
    place.moveBottom(point.y() - gap);
  }
  place.moveLeft(std::clamp(place.left(), bounds.left(), std::max(bounds.left(), bounds.right() - size.width())));
  place.moveTop(std::clamp(place.top(), bounds.top(), std::max(bounds.top(), bounds.bottom() - size.height())));
  return place;
}

} // namespace

void paintHoverCard(QPainter& painter, const QPointF& point, const QStringList& lines, const QRectF& bounds,
                    const QColor& seriesColor, PlotTheme theme) {
  const PlotColors colors = PlotColors::of(theme);
  painter.setRenderHint(QPainter::Antialiasing, true);
  painter.setPen(QPen(colors.background, 4.0));
  painter.setBrush(Qt::NoBrush);
  painter.drawEllipse(point, 6.0, 6.0);
  painter.setPen(QPen(seriesColor, 2.0));
  painter.drawEllipse(point, 6.0, 6.0);
  if (lines.isEmpty()) {
    return;
  }
  const QFont font = PlotFonts::standard().label;
  const QFontMetricsF metrics(font);
  double width = 0.0;
  for (const QString& line : lines) {
    width = std::max(width, metrics.horizontalAdvance(line));
  }
  width = std::min(width, bounds.width() - 24.0);
  const double lineHeight = std::ceil(metrics.height()) + 1.0;
  const QSizeF size(std::ceil(width) + 18.0, lineHeight * static_cast<double>(lines.size()) + 10.0);
  const QRectF card = beside(point, size, bounds, 12.0);
  painter.setPen(QPen(colors.cardBorder, 1.0));
  painter.setBrush(colors.card);
  painter.drawRoundedRect(card.adjusted(0.5, 0.5, -0.5, -0.5), 4.0, 4.0);
  painter.setPen(Qt::NoPen);
  painter.setBrush(seriesColor);
  painter.drawRoundedRect(QRectF(card.left() + 4.0, card.top() + 6.0, 3.0, card.height() - 12.0), 1.5, 1.5);
  painter.setBrush(Qt::NoBrush);
  painter.setFont(font);
  painter.setPen(colors.text);
  double y = card.top() + 5.0;
  for (const QString& line : lines) {
    painter.drawText(QRectF(card.left() + 11.0, y, width + 4.0, lineHeight), Qt::AlignLeft | Qt::AlignVCenter,
                     metrics.elidedText(line, Qt::ElideRight, width + 1.0));
    y += lineHeight;
  }
}

void paintRubberBand(QPainter& painter, const QRectF& band, PlotTheme theme) {
  const PlotColors colors = PlotColors::of(theme);
  QColor border = colors.selection;
  border.setAlpha(220);
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(QPen(border, 1.0));
  painter.setBrush(colors.selection);
  painter.drawRect(band.normalized());
  painter.setBrush(Qt::NoBrush);
}

void paintMagnifier(QPainter& painter, ChartScene& scene, const PlotSpec& spec, const PlotWindow& window,
                    const PlotLayout& layout, const QPointF& position, PlotTheme theme) {
  const QRectF& plot = layout.plot;
  const double diameter = std::floor(std::clamp(0.55 * std::min(plot.width(), plot.height()), 60.0, 190.0));
  const QRectF lens = beside(position, QSizeF(diameter, diameter), plot, 16.0);
  const QRectF square(std::round(lens.left()), std::round(lens.top()), diameter, diameter);
  const double halfX = 0.5 * diameter / (lensZoom * plot.width());
  const double halfY = 0.5 * diameter / (lensZoom * plot.height());
  const double u = (position.x() - plot.left()) / plot.width();
  const double v = (plot.bottom() - position.y()) / plot.height();
  PlotLayout inside;
  inside.area = square;
  inside.plot = square;
  const PlotColors colors = PlotColors::of(theme);
  painter.save();
  QPainterPath round;
  round.addEllipse(square);
  painter.setRenderHint(QPainter::Antialiasing, true);
  painter.setClipPath(round, Qt::IntersectClip);
  painter.fillRect(square, colors.background);
  scene.paint(painter, spec, window.part(u - halfX, v - halfY, u + halfX, v + halfY), inside, theme);
  const QPointF middle = square.center();
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(QPen(colors.softText, 1.0));
  painter.drawLine(middle - QPointF(6, 0), middle + QPointF(6, 0));
  painter.drawLine(middle - QPointF(0, 6), middle + QPointF(0, 6));
  painter.restore();
  painter.setRenderHint(QPainter::Antialiasing, true);
  painter.setPen(QPen(colors.cardBorder, 2.0));
  painter.setBrush(Qt::NoBrush);
  painter.drawEllipse(square);
}

} // namespace straightedge::gui
