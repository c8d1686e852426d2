// Where everything on a plot goes: computed once from text sizes, then painted as it is and tested without pixels.
#pragma once

#include "app/gui/plots/plot_spec.h"
#include "app/gui/plots/plot_window.h"
#include "app/gui/plots/theme.h"
#include "app/gui/plots/ticks.h"

#include <QList>
#include <QRectF>
#include <QString>

namespace straightedge::gui {

struct PlacedText {
  QRectF rect; ///< empty text = nothing there
  QString text;
};

struct LegendEntry {
  int series = -1; ///< −1: "+ 3 more", which cannot be switched
  QRectF rect;
  QString text;
};

/// Rectangles in the painter's logical pixels. Nothing overlaps: titles, labels, remarks, legend and note lie outside
/// the plot area and apart from each other. Rotated titles have the rectangle they cover on paper.
struct PlotLayout {
  QRectF area;
  QRectF plot; ///< whole pixels
  PlacedText title, xTitle, yTitle, rightTitle;
  PlacedText xRemark, yRemark, rightRemark;
  PlacedText note;
  QList<PlacedText> xLabels, yLabels, rightLabels;
  Ticks xTicks, yTicks, rightTicks;
  QList<LegendEntry> legend;

  QPointF toPixels(const PlotWindow& window, double x, double y, bool rightAxis = false) const;
  QPointF toData(const PlotWindow& window, const QPointF& pixels) const;
};

PlotLayout layOut(const PlotSpec& spec, const PlotWindow& window, const QRectF& area, const PlotFonts& fonts);

/// Title, legend and note are common to all kinds of plots; `plot` is what they leave.
PlotLayout layOutFrame(const PlotSpec& spec, const QRectF& area, const PlotFonts& fonts);

/// "Sensor angle (°)" -> "Sensor angle" and "°"
std::pair<QString, QString> nameAndUnit(const QString& axisTitle);

constexpr double legendSwatchWidth = 22.0;

} // namespace straightedge::gui
