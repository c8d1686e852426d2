#include "app/gui/plots/plot_layout.h"

#include <QCoreApplication>
#include <QFontMetricsF>

#include <algorithm>
#include <cmath>

namespace straightedge::gui {
namespace {

constexpr double pad = 8.0;
constexpr double tickLength = 5.0;
constexpr double labelGap = 4.0; ///< between tick and label
constexpr double entryGap = 18.0;
constexpr double swatchGap = 6.0;

/// Angle axes get steps of 45° without being told, as soon as they show a good part of the turn.
std::optional<double> stepFor(const PlotAxis& axis, const AxisScale& scale) {
  if (axis.tickStep) {
    return axis.tickStep;
  }
  if (nameAndUnit(axis.title).second == QStringLiteral("°") && scale.span() >= 180.0 && scale.span() <= 3000.0) {
    return 45.0;
  }
  return {};
}

double textWidth(const QFontMetricsF& metrics, const QString& text) {
  return std::ceil(metrics.horizontalAdvance(text)) + 1.0;
}

double widest(const QFontMetricsF& metrics, const QStringList& texts) {
  double width = 0.0;
  for (const QString& text : texts) {
    width = std::max(width, textWidth(metrics, text));
  }
  return width;
}

QList<int> namedSeries(const PlotSpec& spec) {
  QList<int> named;
  for (int i = 0; i < spec.series.size(); ++i) {
    if (!spec.series[i].name.isEmpty()) {
      named << i;
    }
  }
  return named;
}

struct LegendPlan {
  QList<LegendEntry> entries; ///< relative to the legend's corner
  double height = 0.0;
};

/// Rows from left to right; what does not fit into `most` rows is summed up in a last entry.
LegendPlan rowsOfLegend(const PlotSpec& spec, const QFontMetricsF& metrics, double width, int most) {
  LegendPlan plan;
  const double rowHeight = std::ceil(metrics.height()) + 3.0;
  const QList<int> named = namedSeries(spec);
  double x = 0.0;
  int row = 0;
  for (qsizetype k = 0; k < named.size(); ++k) {
    const double room = std::max(10.0, width - legendSwatchWidth - swatchGap);
    const QString text = metrics.elidedText(spec.series[named[k]].name, Qt::ElideMiddle, room);
    const double entryWidth = legendSwatchWidth + swatchGap + textWidth(metrics, text);
    const bool wraps = x > 0.0 && x + entryWidth > width;
    const qsizetype remaining = named.size() - k;
    const QString more = QCoreApplication::translate("Plot", "+ %1 more").arg(remaining);
    const double moreWidth = remaining > 1 ? entryGap + textWidth(metrics, more) : 0.0;
    const bool lastRow = row + 1 >= most;
    if (lastRow && x > 0.0 && (wraps || (remaining > 1 && x + entryWidth + moreWidth > width))) {
      plan.entries << LegendEntry{
          -1, QRectF(x, row * rowHeight, std::min(textWidth(metrics, more), width - x), rowHeight), more};
      break;
    }
    if (wraps) {
      x = 0.0;
      ++row;
    }
    plan.entries << LegendEntry{named[k], QRectF(x, row * rowHeight, std::min(entryWidth, width - x), rowHeight), text};
    x += entryWidth + entryGap;
  }
  plan.height = named.isEmpty() ? 0.0 : (row + 1) * rowHeight;
  return plan;
}

LegendPlan columnOfLegend(const PlotSpec& spec, const QFontMetricsF& metrics, double width, double height) {
  LegendPlan plan;
  const double rowHeight = std::ceil(metrics.height()) + 5.0;
  const QList<int> named = namedSeries(spec);
  const auto rows = static_cast<qsizetype>(height / rowHeight);
  for (qsizetype k = 0; k < named.size(); ++k) {
    const QRectF place(0.0, static_cast<double>(k) * rowHeight, width, rowHeight);
    if (k + 1 >= rows && k + 1 < named.size()) {
      plan.entries << LegendEntry{-1, place, QCoreApplication::translate("Plot", "+ %1 more").arg(named.size() - k)};
      break;
    }
    const QString text =
        metrics.elidedText(spec.series[named[k]].name, Qt::ElideMiddle, width - legendSwatchWidth - swatchGap);
    plan.entries << LegendEntry{named[k], place, text};
  }
  return plan;
}

void placeLegend(PlotLayout& layout, const PlotSpec& spec, const QFontMetricsF& metrics, QRectF& inner) {
  if (namedSeries(spec).isEmpty() || inner.height() < 90.0) {
    return;
  }
  LegendPlan rows = rowsOfLegend(spec, metrics, inner.width(), 100);
  const double rowHeight = std::ceil(metrics.height()) + 3.0;
  const bool manyRows = rows.height > 2.5 * rowHeight;
  if (manyRows && inner.width() >= 640.0) {
    QStringList names;
    for (const PlotSeries& series : spec.series) {
      names << series.name;
    }
    const double width =
        std::min(widest(metrics, names) + legendSwatchWidth + swatchGap, std::floor(0.3 * inner.width()));
    for (LegendEntry entry : columnOfLegend(spec, metrics, width, inner.height()).entries) {
      entry.rect.translate(inner.right() - width, inner.top() + pad);
      layout.legend << entry;
    }
    inner.setRight(inner.right() - width - 2.0 * pad);
    return;
  }
  const int most = std::max(1, static_cast<int>(0.2 * inner.height() / rowHeight));
  if (rows.height > most * rowHeight) {
    rows = rowsOfLegend(spec, metrics, inner.width(), most);
  }
  for (LegendEntry entry : rows.entries) {
    entry.rect.translate(inner.left(), inner.top());
    layout.legend << entry;
  }
  inner.setTop(inner.top() + rows.height);
}

QList<PlacedText> besideTicks(const Ticks& ticks, const AxisScale& scale, const QRectF& plot,
                              const QFontMetricsF& metrics, bool onRight) {
  QList<PlacedText> labels;
  const double height = std::ceil(metrics.height());
  for (qsizetype i = 0; i < ticks.positions.size(); ++i) {
    const double width = textWidth(metrics, ticks.labels[i]);
    const double y = plot.bottom() - scale.toUnit(ticks.positions[i]) * plot.height();
    const double x = onRight ? plot.right() + tickLength + labelGap : plot.left() - tickLength - labelGap - width;
    labels << PlacedText{QRectF(x, y - 0.5 * height, width, height), ticks.labels[i]};
  }
  return labels;
}

} // namespace

std::pair<QString, QString> nameAndUnit(const QString& axisTitle) {
  const qsizetype open = axisTitle.lastIndexOf(u'(');
  if (open < 0 || !axisTitle.endsWith(u')')) {
    return {axisTitle, {}};
  }
  return {axisTitle.left(open).trimmed(), axisTitle.mid(open + 1, axisTitle.size() - open - 2)};
}

QPointF PlotLayout::toPixels(const PlotWindow& window, double x, double y, bool rightAxis) const {
  const AxisScale& vertical = rightAxis ? window.right : window.y;
  return {plot.left() + window.x.toUnit(x) * plot.width(), plot.bottom() - vertical.toUnit(y) * plot.height()};
}

QPointF PlotLayout::toData(const PlotWindow& window, const QPointF& pixels) const {
  return {window.x.fromUnit((pixels.x() - plot.left()) / plot.width()),
          window.y.fromUnit((plot.bottom() - pixels.y()) / plot.height())};
}

PlotLayout layOutFrame(const PlotSpec& spec, const QRectF& area, const PlotFonts& fonts) {
  PlotLayout layout;
  layout.area = area;
  QRectF inner = area.adjusted(pad + 2.0, pad, -pad - 2.0, -pad);
  const QFontMetricsF titleMetrics(fonts.title);
  if (!spec.title.isEmpty() && area.height() >= 130.0) {
    const double height = std::ceil(titleMetrics.height());
    layout.title = {QRectF(inner.left(), inner.top(), inner.width(), height),
                    titleMetrics.elidedText(spec.title, Qt::ElideRight, inner.width())};
    inner.setTop(inner.top() + height + 5.0);
  }
  QStringList notes{spec.note, leftOutNote(spec)};
  notes.removeAll(QString());
  if (!notes.isEmpty() && area.height() >= 150.0) {
    const QFontMetricsF metrics(fonts.note);
    const double height = std::ceil(metrics.height());
    layout.note = {QRectF(inner.left(), inner.bottom() - height, inner.width(), height),
                   metrics.elidedText(notes.join(QStringLiteral("  ·  ")), Qt::ElideRight, inner.width())};
    inner.setBottom(inner.bottom() - height - 5.0);
  }
  placeLegend(layout, spec, QFontMetricsF(fonts.label), inner);
  layout.plot = inner;
  return layout;
}

PlotLayout layOut(const PlotSpec& spec, const PlotWindow& window, const QRectF& area, const PlotFonts& fonts) {
  PlotLayout layout = layOutFrame(spec, area, fonts);
  const QFontMetricsF labels(fonts.label);
  const QFontMetricsF titles(fonts.axisTitle);
  const double labelHeight = std::ceil(labels.height());
  const double titleHeight = std::ceil(titles.height());
  QRectF inner = layout.plot;
  const bool hasRight = spec.right.has_value();

  // From top and bottom: half a tick label stands out above, labels and title below.
  const double labelRow = tickLength + labelGap + labelHeight;
  inner.setTop(inner.top() + std::ceil(0.5 * labelHeight) + 2.0);
  const double titleRow = spec.x.title.isEmpty() ? 0.0 : titleHeight + 3.0;
  inner.setBottom(inner.bottom() - labelRow - titleRow);
  const auto heightOf = [labelHeight](const QString& text) { return text.isEmpty() ? 0.0 : labelHeight; };
  const auto verticalTicks = [&](const PlotAxis& axis, const AxisScale& scale) {
    return fittingTicks(scale, std::max(10.0, inner.height()), 0.9 * labelHeight, stepFor(axis, scale), heightOf);
  };
  layout.yTicks = verticalTicks(spec.y, window.y);
  if (hasRight) {
    layout.rightTicks = verticalTicks(*spec.right, window.right);
  }
  if (!layout.yTicks.remark.isEmpty() || !layout.rightTicks.remark.isEmpty()) {
    inner.setTop(inner.top() + labelHeight);
    layout.yTicks = verticalTicks(spec.y, window.y);
    layout.rightTicks = hasRight ? verticalTicks(*spec.right, window.right) : Ticks{};
  }

  // From the sides.
  const QRectF outer = inner;
  const double sideTitle = titleHeight + 5.0;
  inner.setLeft(inner.left() + widest(labels, layout.yTicks.labels) + tickLength + labelGap +
                (spec.y.title.isEmpty() ? 0.0 : sideTitle));
  if (hasRight) {
    inner.setRight(inner.right() - widest(labels, layout.rightTicks.labels) - tickLength - labelGap -
                   (spec.right->title.isEmpty() ? 0.0 : sideTitle));
  }
  inner = QRectF(QPointF(std::ceil(inner.left()), std::ceil(inner.top())),
                 QPointF(std::floor(inner.right()), std::floor(inner.bottom())));
  if (inner.width() < 10.0) {
    inner.setWidth(10.0);
  }
  if (inner.height() < 10.0) {
    inner.setHeight(10.0);
  }
  const auto horizontalTicks = [&] {
    return fittingTicks(window.x, inner.width(), 1.2 * labelHeight, stepFor(spec.x, window.x),
                        [&labels](const QString& text) { return textWidth(labels, text); });
  };
  layout.xTicks = horizontalTicks();
  if (!layout.xTicks.positions.isEmpty()) { // the last label may reach beyond the plot
    const double reach = inner.left() + window.x.toUnit(layout.xTicks.positions.last()) * inner.width() +
                         0.5 * textWidth(labels, layout.xTicks.labels.last());
    if (reach > area.right() - 2.0 || (!layout.legend.isEmpty() && reach > outer.right() + pad)) {
      inner.setRight(std::floor(inner.right() - (reach - outer.right())));
      layout.xTicks = horizontalTicks();
    }
  }
  layout.plot = inner;

  layout.yLabels = besideTicks(layout.yTicks, window.y, inner, labels, false);
  layout.rightLabels =
      hasRight ? besideTicks(layout.rightTicks, window.right, inner, labels, true) : QList<PlacedText>();
  const double labelTop = inner.bottom() + tickLength + labelGap;
  for (qsizetype i = 0; i < layout.xTicks.positions.size(); ++i) {
    const double width = textWidth(labels, layout.xTicks.labels[i]);
    const double x = inner.left() + window.x.toUnit(layout.xTicks.positions[i]) * inner.width();
    layout.xLabels << PlacedText{QRectF(x - 0.5 * width, labelTop, width, labelHeight), layout.xTicks.labels[i]};
  }

  const double titleTop = labelTop + labelHeight + 3.0;
  double titleRight = inner.right();
  if (!layout.xTicks.remark.isEmpty()) {
    const double width = textWidth(labels, layout.xTicks.remark);
    layout.xRemark = {QRectF(inner.right() - width, titleTop, width, labelHeight), layout.xTicks.remark};
    titleRight -= width + pad;
  }
  if (!spec.x.title.isEmpty()) {
    const QString text = titles.elidedText(spec.x.title, Qt::ElideRight, titleRight - inner.left());
    const double width = std::min(textWidth(titles, text), titleRight - inner.left());
    const double left = std::min(inner.center().x() - 0.5 * width, titleRight - width);
    layout.xTitle = {QRectF(left, titleTop, width, titleHeight), text};
  }
  const auto besidePlot = [&](const QString& title, double left) {
    // Beside the plot, and where it is long down to the end of the x axis' title.
    const double bottom = inner.bottom() + labelRow + titleRow;
    const QString text = titles.elidedText(title, Qt::ElideMiddle, bottom - inner.top());
    const double length = std::min(textWidth(titles, text), bottom - inner.top());
    const double top = std::clamp(inner.center().y() - 0.5 * length, inner.top(), bottom - length);
    return PlacedText{QRectF(left, top, titleHeight, length), text};
  };
  if (!spec.y.title.isEmpty()) {
    layout.yTitle = besidePlot(spec.y.title, outer.left() - 2.0);
  }
  if (hasRight && !spec.right->title.isEmpty()) {
    layout.rightTitle = besidePlot(spec.right->title, outer.right() - titleHeight + 2.0);
  }
  // The remarks share a row above the plot, each at its own side of the whole.
  const double remarkTop = inner.top() - std::ceil(0.5 * labelHeight) - labelHeight;
  const double room = hasRight ? 0.5 * (outer.width() - pad) : outer.width();
  const auto remark = [&](const QString& text, bool onRight) {
    const QString shown = labels.elidedText(text, Qt::ElideRight, room - 1.0);
    const double width = std::min(textWidth(labels, shown), room);
    return PlacedText{QRectF(onRight ? outer.right() - width : outer.left(), remarkTop, width, labelHeight), shown};
  };
  if (!layout.yTicks.remark.isEmpty()) {
    layout.yRemark = remark(layout.yTicks.remark, false);
  }
  if (!layout.rightTicks.remark.isEmpty()) {
    layout.rightRemark = remark(layout.rightTicks.remark, true);
  }
  return layout;
}

} // namespace straightedge::gui
