#include "app/gui/plots/plot_painting.h"

#include "app/gui/plots/guides.h"
#include "app/gui/plots/painter_device.h"
#include "app/gui/plots/polar_plot.h"
#include "app/gui/plots/theme.h"

#include <QPainter>

#include <cmath>

namespace straightedge::gui {
namespace {

void paintText(QPainter& painter, const PlacedText& text, const QFont& font, const QColor& color,
               Qt::Alignment alignment = Qt::AlignCenter) {
  if (text.text.isEmpty()) {
    return;
  }
  painter.setFont(font);
  painter.setPen(color);
  painter.drawText(text.rect, static_cast<int>(alignment) | Qt::TextSingleLine | Qt::TextDontClip, text.text);
}

void paintRotated(QPainter& painter, const PlacedText& text, const QFont& font, const QColor& color, double degrees) {
  if (text.text.isEmpty()) {
    return;
  }
  painter.save();
  painter.translate(text.rect.center());
  painter.rotate(degrees);
  const QSizeF turned = text.rect.size().transposed();
  const QRectF around(QPointF(-0.5 * turned.width(), -0.5 * turned.height()), turned);
  paintText(painter, {around, text.text}, font, color);
  painter.restore();
}

void paintMinorGrid(QPainter& painter, const PlotLayout& layout, const PlotWindow& window, const QColor& color) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(QPen(color, 1.0));
  const QRectF& plot = layout.plot;
  if (window.x.logarithmic) {
    for (const double position : layout.xTicks.minor) {
      const double x = plot.left() + window.x.toUnit(position) * plot.width();
      painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
    }
  }
  if (window.y.logarithmic) {
    for (const double position : layout.yTicks.minor) {
      const double y = plot.bottom() - window.y.toUnit(position) * plot.height();
      painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
    }
  }
  painter.restore();
}

void paintMinorTicks(QPainter& painter, const PlotLayout& layout, const PlotWindow& window, const QColor& color) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(QPen(color, 1.0));
  const QRectF& plot = layout.plot;
  for (const double position : layout.xTicks.minor) {
    const double x = plot.left() + window.x.toUnit(position) * plot.width();
    painter.drawLine(QPointF(x, plot.bottom()), QPointF(x, plot.bottom() + 3.0));
  }
  for (const double position : layout.yTicks.minor) {
    const double y = plot.bottom() - window.y.toUnit(position) * plot.height();
    painter.drawLine(QPointF(plot.left() - 3.0, y), QPointF(plot.left(), y));
  }
  painter.restore();
}

void paintMarker(QPainter& painter, const QPointF& at, MarkerShape shape, const QColor& color) {
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  const double r = 3.5;
  switch (shape) {
  case MarkerShape::Square:
    painter.drawRect(QRectF(at.x() - 3.0, at.y() - 3.0, 6.0, 6.0));
    break;
  case MarkerShape::Diamond:
    painter.drawPolygon(
        QPolygonF({at + QPointF(0, -4.2), at + QPointF(4.2, 0), at + QPointF(0, 4.2), at + QPointF(-4.2, 0)}));
    break;
  case MarkerShape::Triangle:
    painter.drawPolygon(QPolygonF({at + QPointF(0, -4.0), at + QPointF(4.0, 3.2), at + QPointF(-4.0, 3.2)}));
    break;
  case MarkerShape::Cross:
    painter.setPen(QPen(color, 1.6));
    painter.drawLine(at + QPointF(-r, -r), at + QPointF(r, r));
    painter.drawLine(at + QPointF(-r, r), at + QPointF(r, -r));
    break;
  case MarkerShape::Plus:
    painter.setPen(QPen(color, 1.6));
    painter.drawLine(at + QPointF(-r, 0), at + QPointF(r, 0));
    painter.drawLine(at + QPointF(0, -r), at + QPointF(0, r));
    break;
  default:
    painter.drawEllipse(at, r, r);
  }
  painter.setBrush(Qt::NoBrush);
}

void paintLegend(QPainter& painter, const PlotSpec& spec, const PlotLayout& layout, PlotTheme theme) {
  const PlotColors colors = PlotColors::of(theme);
  const QFont font = PlotFonts::standard().label;
  painter.setRenderHint(QPainter::Antialiasing, true);
  for (const LegendEntry& entry : layout.legend) {
    if (entry.series < 0) {
      paintText(painter, {entry.rect, entry.text}, font, colors.softText, Qt::AlignLeft | Qt::AlignVCenter);
      continue;
    }
    const PlotSeries& series = spec.series[entry.series];
    QColor color = PlotColors::series(series.color, theme);
    QColor text = colors.text;
    if (!series.visible) { // switched off: faint, so that it can be found and switched on
      color.setAlpha(70);
      text = colors.softText;
      text.setAlpha(130);
    }
    const double y = entry.rect.center().y();
    const double left = entry.rect.left();
    const double right = left + legendSwatchWidth;
    if (series.style == SeriesStyle::Bars) {
      painter.fillRect(QRectF(left + 5.0, y - 5.0, 12.0, 10.0), color);
    } else {
      if (series.style != SeriesStyle::Points) {
        QPen pen(color, 2.0);
        pen.setCapStyle(Qt::FlatCap);
        if (series.dashed) {
          pen.setDashPattern({4.0, 2.5});
        }
        painter.setPen(pen);
        painter.drawLine(QPointF(left, y), QPointF(right, y));
      }
      if (series.style == SeriesStyle::Points || series.style == SeriesStyle::LineAndPoints) {
        paintMarker(painter, {0.5 * (left + right), y}, markerOf(series.color), color);
      }
    }
    QFont entryFont = font;
    entryFont.setStrikeOut(!series.visible);
    paintText(painter, {entry.rect.adjusted(legendSwatchWidth + 6.0, 0, 0, 0), entry.text}, entryFont, text,
              Qt::AlignLeft | Qt::AlignVCenter);
  }
}

} // namespace

void paintFrameTexts(QPainter& painter, const PlotSpec& spec, const PlotLayout& layout, PlotTheme theme) {
  const PlotColors colors = PlotColors::of(theme);
  const PlotFonts fonts = PlotFonts::standard();
  paintText(painter, layout.title, fonts.title, colors.text, Qt::AlignLeft | Qt::AlignVCenter);
  paintText(painter, layout.note, fonts.note, colors.softText, Qt::AlignLeft | Qt::AlignVCenter);
  paintText(painter, layout.xTitle, fonts.axisTitle, colors.text);
  paintText(painter, layout.xRemark, fonts.label, colors.softText);
  paintText(painter, layout.yRemark, fonts.label, colors.softText);
  paintText(painter, layout.rightRemark, fonts.label, colors.softText);
  paintRotated(painter, layout.yTitle, fonts.axisTitle, colors.text, -90.0);
  paintRotated(painter, layout.rightTitle, fonts.axisTitle, colors.text, 90.0);
  for (const auto* labels : {&layout.xLabels, &layout.yLabels, &layout.rightLabels}) {
    for (const PlacedText& label : *labels) {
      paintText(painter, label, fonts.label, colors.softText);
    }
  }
  paintLegend(painter, spec, layout, theme);
}

void paintFrame(QPainter& painter, ChartScene& scene, const PlotSpec& spec, const PlotWindow& window,
                const PlotLayout& layout, PlotTheme theme, GuidePainting guides) {
  const PlotColors colors = PlotColors::of(theme);
  painter.save();
  painter.setClipRect(layout.area, Qt::IntersectClip);
  painter.fillRect(layout.area, colors.background);
  if (spec.polar) {
    paintPolarPlot(painter, spec, layout, theme);
    painter.restore();
    return;
  }
  paintMinorGrid(painter, layout, window, colors.minorGrid);
  scene.paint(painter, spec, window, layout, theme);
  paintMinorTicks(painter, layout, window, colors.axis);
  if (guides == GuidePainting::Include) {
    paintGuides(painter, spec, window, layout, theme);
  }
  paintFrameTexts(painter, spec, layout, theme);
  painter.restore();
}

void paintPlot(QPainter& painter, const QRectF& area, const PlotSpec& spec, PlotTheme theme) {
  ChartScene scene;
  const PlotWindow window = wholeWindow(spec);
  const PlotLayout layout =
      spec.polar ? layOutFrame(spec, area, PlotFonts::standard()) : layOut(spec, window, area, PlotFonts::standard());
  paintFrame(painter, scene, spec, window, layout, theme, GuidePainting::Include);
}

} // namespace straightedge::gui
