#include "app/gui/plots/guides.h"

#include "app/gui/plots/theme.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <optional>

namespace straightedge::gui {
namespace {

double unitOf(const PlotGuide& guide, const PlotWindow& window) {
  return (guide.vertical ? window.x : window.y).toUnit(guide.value);
}

bool isInside(double unit) { return unit >= -1e-9 && unit <= 1.0 + 1e-9; }

QLineF lineOf(const PlotGuide& guide, double unit, const QRectF& plot) {
  if (guide.vertical) {
    const double x = plot.left() + unit * plot.width();
    return {x, plot.top(), x, plot.bottom()};
  }
  const double y = plot.bottom() - unit * plot.height();
  return {plot.left(), y, plot.right(), y};
}

/// Beside the line, inside the plot, clear of labels that are there already and of the other guides' lines.
QRectF labelPlace(const PlotGuide& guide, const QLineF& line, const QSizeF& size, const QRectF& plot,
                  const QList<QRectF>& taken, const QList<QRectF>& otherLines) {
  constexpr int rows = 6;
  std::optional<QRectF> best;
  int fewestHits = 0;
  for (int row = 0; row < rows; ++row) {
    for (const bool firstSide : {true, false}) {
      QRectF place(QPointF(), size);
      if (guide.vertical) {
        place.moveTop(plot.top() + 4.0 + row * (size.height() + 3.0));
        firstSide ? place.moveLeft(line.x1() + 4.0) : place.moveRight(line.x1() - 4.0);
      } else {
        place.moveRight(plot.right() - 4.0 - row * (size.width() + 6.0));
        firstSide ? place.moveBottom(line.y1() - 2.0) : place.moveTop(line.y1() + 2.0);
      }
      if (!plot.contains(place)) {
        continue;
      }
      const auto meets = [&](const QRectF& other) { return other.intersects(place); };
      // A label over a label cannot be read; one over a line can.
      const auto hits =
          static_cast<int>(100 * std::ranges::count_if(taken, meets) + std::ranges::count_if(otherLines, meets));
      if (!best || hits < fewestHits) {
        best = place;
        fewestHits = hits;
      }
    }
  }
  return best.value_or(QRectF(plot.topLeft() + QPointF(4.0, 4.0), size));
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
    if (!isInside(unit)) {
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
  }
  for (int i = 0; i < spec.guides.size(); ++i) { // no line runs over a label
    const PlotGuide& guide = spec.guides[i];
    const double unit = unitOf(guide, window);
    if (!isInside(unit)) {
      continue;
    }
    const QLineF line = lineOf(guide, unit, layout.plot);
    const QString text = guideText(guide, window);
    const QSizeF size(metrics.horizontalAdvance(text) + 9.0, metrics.height() + 2.0);
    QList<QRectF> otherLines;
    for (int j = 0; j < spec.guides.size(); ++j) {
      if (const double there = unitOf(spec.guides[j], window); j != i && isInside(there)) {
        const QLineF other = lineOf(spec.guides[j], there, layout.plot);
        otherLines << QRectF(other.p1(), other.p2()).adjusted(-1.0, -1.0, 1.0, 1.0);
      }
    }
    const QRectF place = labelPlace(guide, line, size, layout.plot, taken, otherLines);
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
    if (!guide.draggable || !isInside(unit)) {
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
