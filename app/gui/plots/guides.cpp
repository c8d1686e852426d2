#include "app/gui/plots/guides.h"

#include "app/gui/plots/theme.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace straightedge::gui {
namespace {

double unitOf(const PlotGuide& guide, const PlotWindow& window) {
  return (guide.vertical ? window.x : window.y).toUnit(guide.value);
}

QLineF lineOf(const PlotGuide& guide, double unit, const QRectF& plot) {
  if (guide.vertical) {
    const double x = plot.left() + unit * plot.width();
    return {x, plot.top(), x, plot.bottom()};
  }
  const double y = plot.bottom() - unit * plot.height();
  return {plot.left(), y, plot.right(), y};
}

/// Beside the line, inside the plot, clear of labels that are there already.
QRectF labelPlace(const PlotGuide& guide, const QLineF& line, const QSizeF& size, const QRectF& plot,
                  const QList<QRectF>& taken) {
  QRectF place(QPointF(), size);
  if (guide.vertical) {
    place.moveTopLeft({line.x1() + 4.0, plot.top() + 4.0});
    if (place.right() > plot.right()) {
      place.moveRight(line.x1() - 4.0);
    }
  } else {
    place.moveBottomRight({plot.right() - 4.0, line.y1() - 2.0});
    if (place.top() < plot.top()) {
      place.moveTop(line.y1() + 2.0);
    }
  }
  for (int turn = 0; turn < 8; ++turn) {
    const auto hit = std::find_if(taken.begin(), taken.end(), [&](const QRectF& r) { return r.intersects(place); });
    if (hit == taken.end()) {
      break;
    }
    if (guide.vertical) {
      place.moveTop(hit->bottom() + 3.0);
    } else {
      place.moveRight(hit->left() - 6.0);
    }
  }
  return place;
}

} // namespace

QString guideText(const PlotGuide& guide, const PlotWindow& window) {
  QString text = guide.label;
  if (!text.isEmpty()) {
    text += u' ';
  }
  text += readableValue(guide.value, guide.vertical ? window.x : window.y);
  // "0.5°" but "64 entries"
  if (!guide.unit.isEmpty()) {
    text += (guide.unit == QStringLiteral("°") ? QString() : QStringLiteral(" ")) + guide.unit;
  }
  return text;
}

void paintGuides(QPainter& painter, const PlotSpec& spec, const PlotWindow& window, const PlotLayout& layout,
                 PlotTheme theme, int highlighted) {
  const PlotColors colors = PlotColors::of(theme);
  const QFont font = PlotFonts::standard().label;
  const QFontMetricsF metrics(font);
  QList<QRectF> taken;
  painter.save();
  painter.setClipRect(layout.plot.adjusted(-1, -1, 1, 1), Qt::IntersectClip);
  painter.setFont(font);
  for (int i = 0; i < spec.guides.size(); ++i) {
    const PlotGuide& guide = spec.guides[i];
    const double unit = unitOf(guide, window);
    if (!(unit >= -1e-9 && unit <= 1.0 + 1e-9)) {
      continue;
    }
    const QColor color = PlotColors::series(guide.color, theme);
    const QLineF line = lineOf(guide, unit, layout.plot);
    QPen pen(color, i == highlighted ? 2.5 : 1.5);
    if (!guide.draggable) {
      pen.setDashPattern({6.0, 4.0});
    }
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(pen);
    painter.drawLine(line);
    painter.setRenderHint(QPainter::Antialiasing, true);
    if (guide.draggable) { // a grip says that it can be moved
      const QPointF grip = guide.vertical ? QPointF(line.x1(), layout.plot.bottom() - 14.0)
                                          : QPointF(layout.plot.left() + 14.0, line.y1());
      const QSizeF size = guide.vertical ? QSizeF(8.0, 16.0) : QSizeF(16.0, 8.0);
      painter.setPen(QPen(colors.background, 1.0));
      painter.setBrush(color);
      painter.drawRoundedRect(QRectF(grip - QPointF(0.5 * size.width(), 0.5 * size.height()), size), 3.0, 3.0);
      painter.setBrush(Qt::NoBrush);
    }
    const QString text = guideText(guide, window);
    const QSizeF size(metrics.horizontalAdvance(text) + 9.0, metrics.height() + 2.0);
    const QRectF place = labelPlace(guide, line, size, layout.plot, taken);
    taken << place;
    QColor paper = colors.background;
    paper.setAlpha(225);
    painter.setPen(Qt::NoPen);
    painter.setBrush(paper);
    painter.drawRoundedRect(place, 3.0, 3.0);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(colors.text);
    painter.drawText(place, Qt::AlignCenter, text);
  }
  painter.restore();
}

int guideAt(const PlotSpec& spec, const PlotWindow& window, const PlotLayout& layout, const QPointF& position,
            double reach) {
  if (!layout.plot.adjusted(-reach, -reach, reach, reach).contains(position)) {
    return -1;
  }
  int nearest = -1;
  double smallest = reach;
  for (int i = 0; i < spec.guides.size(); ++i) {
    const PlotGuide& guide = spec.guides[i];
    const double unit = unitOf(guide, window);
    if (!guide.draggable || !(unit >= -1e-9 && unit <= 1.0 + 1e-9)) {
      continue;
    }
    const QLineF line = lineOf(guide, unit, layout.plot);
    const double distance = guide.vertical ? std::abs(position.x() - line.x1()) : std::abs(position.y() - line.y1());
    if (distance <= smallest) {
      smallest = distance;
      nearest = i;
    }
  }
  return nearest;
}

double draggedValue(const PlotGuide& guide, const PlotWindow& window, const PlotLayout& layout,
                    const QPointF& position) {
  const QRectF& plot = layout.plot;
  const double unit =
      guide.vertical ? (position.x() - plot.left()) / plot.width() : (plot.bottom() - position.y()) / plot.height();
  return (guide.vertical ? window.x : window.y).fromUnit(std::clamp(unit, 0.0, 1.0));
}

} // namespace straightedge::gui
