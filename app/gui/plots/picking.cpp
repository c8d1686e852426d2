#include "app/gui/plots/picking.h"

#include "app/gui/plots/polar_plot.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace straightedge::gui {
namespace {

QPointF placeOf(const PlotSpec& spec, const PlotWindow& window, const PlotLayout& layout, const PolarPlace& polar,
                const PlotSeries& series, qsizetype i) {
  if (spec.polar) {
    return polar.toPixels(series.x[i], series.y[i]);
  }
  return layout.toPixels(window, series.x[i], series.y[i], series.rightAxis);
}

PolarPlace polarOf(const PlotSpec& spec, const PlotLayout& layout) {
  return spec.polar ? placePolar(spec, layout) : PolarPlace{};
}

/// Whether rows can be looked up by x: ascending without NaN. Costs a millisecond per million.
bool ascending(const QList<double>& x) {
  bool result = x.isEmpty() || !std::isnan(x.front());
  for (qsizetype i = 1; i < x.size(); ++i) {
    result = result && x[i] >= x[i - 1];
  }
  return result;
}

std::pair<qsizetype, qsizetype> rowsNear(const PlotSeries& series, double low, double high) {
  const qsizetype count = std::min(series.x.size(), series.y.size());
  if (std::isnan(low) || std::isnan(high) || !ascending(series.x)) {
    return {0, count};
  }
  const auto begin = series.x.begin();
  const auto first = std::lower_bound(begin, begin + count, low);
  const auto last = std::upper_bound(first, begin + count, high);
  return {first - begin, last - begin};
}

QString lineOf(const PlotAxis& axis, const AxisScale& scale, double value) {
  const auto [name, unit] = nameAndUnit(axis.title);
  QString text =
      name.isEmpty() ? readableValue(value, scale) : name + QStringLiteral(": ") + readableValue(value, scale);
  if (!unit.isEmpty()) {
    text += (unit == QStringLiteral("°") ? QString() : QStringLiteral(" ")) + unit;
  }
  return text;
}

} // namespace

PickedPoint nearestPoint(const PlotSpec& spec, const PlotWindow& window, const PlotLayout& layout,
                         const QPointF& position, double reach) {
  PickedPoint nearest;
  if (!spec.polar && !layout.plot.adjusted(-reach, -reach, reach, reach).contains(position)) {
    return nearest;
  }
  const PolarPlace polar = polarOf(spec, layout);
  const QRectF visible = layout.plot.adjusted(-0.5, -0.5, 0.5, 0.5);
  double smallest = reach * reach;
  const double low = layout.toData(window, position - QPointF(reach, 0.0)).x();
  const double high = layout.toData(window, position + QPointF(reach, 0.0)).x();
  for (int s = 0; s < spec.series.size(); ++s) {
    const PlotSeries& series = spec.series[s];
    if (!series.visible) {
      continue;
    }
    if (series.style == SeriesStyle::Bars && !spec.polar) {
      const BarPlace place = barPlace(spec, s);
      const double base = layout.toPixels(window, 0.0, 0.0, series.rightAxis).y();
      for (qsizetype i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
        const double left = layout.toPixels(window, series.x[i] + place.offset, 0.0).x();
        const double right = layout.toPixels(window, series.x[i] + place.offset + place.width, 0.0).x();
        const QPointF top(0.5 * (left + right),
                          layout.toPixels(window, series.x[i], series.y[i], series.rightAxis).y());
        const double foot = std::isfinite(base) ? base : layout.plot.bottom();
        const bool onBar = position.x() >= left && position.x() <= right &&
                           position.y() >= std::min(top.y(), foot) - 3.0 &&
                           position.y() <= std::max(top.y(), foot) + 3.0;
        if (onBar && std::isfinite(top.y())) {
          nearest = {s, static_cast<int>(i), top};
          smallest = 0.0;
        }
      }
      continue;
    }
    const double never = std::numeric_limits<double>::quiet_NaN();
    const auto [first, last] = spec.polar ? rowsNear(series, never, never) : rowsNear(series, low, high);
    for (qsizetype i = first; i < last; ++i) {
      const QPointF place = placeOf(spec, window, layout, polar, series, i);
      if (!spec.polar && !visible.contains(place)) { // also false for NaN
        continue;
      }
      const QPointF away = place - position;
      const double distance = QPointF::dotProduct(away, away);
      if (distance <= smallest) {
        smallest = distance;
        nearest = {s, static_cast<int>(i), place};
      }
    }
  }
  return nearest;
}

QList<int> pointsWithin(const PlotSpec& spec, int series, const PlotWindow& window, const PlotLayout& layout,
                        const QRectF& pixels) {
  QList<int> found;
  const PlotSeries& shown = spec.series[series];
  if (!shown.visible) {
    return found;
  }
  const PolarPlace polar = polarOf(spec, layout);
  const QRectF inside = pixels.normalized();
  for (qsizetype i = 0; i < std::min(shown.x.size(), shown.y.size()); ++i) {
    if (inside.contains(placeOf(spec, window, layout, polar, shown, i))) {
      found << static_cast<int>(i);
    }
  }
  return found;
}

PickedPoint neighbour(const PlotSpec& spec, const PlotWindow& window, const PlotLayout& layout, const PickedPoint& from,
                      int direction) {
  if (!from || from.series >= spec.series.size()) {
    return from;
  }
  const PlotSeries& series = spec.series[from.series];
  const PolarPlace polar = polarOf(spec, layout);
  const QRectF visible = layout.plot.adjusted(-0.5, -0.5, 0.5, 0.5);
  for (qsizetype i = from.index + direction; i >= 0 && i < std::min(series.x.size(), series.y.size()); i += direction) {
    const QPointF place = placeOf(spec, window, layout, polar, series, i);
    if (std::isfinite(place.x()) && std::isfinite(place.y()) && (spec.polar || visible.contains(place))) {
      return {from.series, static_cast<int>(i), place};
    }
  }
  return from;
}

QStringList hoverLines(const PlotSpec& spec, const PlotWindow& window, const PickedPoint& point) {
  QStringList lines;
  if (!point || point.series >= spec.series.size()) {
    return lines;
  }
  const PlotSeries& series = spec.series[point.series];
  if (point.index >= std::min(series.x.size(), series.y.size())) {
    return lines;
  }
  if (point.index < series.pointLabels.size() && !series.pointLabels[point.index].isEmpty()) {
    lines << series.pointLabels[point.index];
  }
  if (!series.name.isEmpty()) {
    lines << series.name;
  }
  const PlotAxis& yAxis = series.rightAxis && spec.right ? *spec.right : spec.y;
  lines << lineOf(spec.x, window.x, series.x[point.index]);
  lines << lineOf(yAxis, window.yOf(series), series.y[point.index]);
  return lines;
}

} // namespace straightedge::gui
