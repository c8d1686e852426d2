// What a two-dimensional plot shows, as plain data: made by app/gui/figures from results, drawn by PlotView on the
// screen and by paintPlot() into pictures. No VTK, no widgets.
#pragma once

#include <QColor>
#include <QList>
#include <QString>

#include <cstdint>
#include <optional>

namespace straightedge::gui {

enum class SeriesStyle : std::uint8_t { Line, Points, LineAndPoints, Steps, Bars };

/// Colours are chosen by role, so that light and dark themes each use their own palette.
enum class SeriesColor : std::uint8_t { Reference, First, Second, Third, Fourth, Fifth, Sixth, Muted, Good, Bad };

struct PlotSeries {
  QString name;       ///< in the legend; empty = not in the legend
  QList<double> x, y; ///< equal lengths; NaN in y breaks the line
  SeriesStyle style = SeriesStyle::Line;
  SeriesColor color = SeriesColor::First;
  bool dashed = false;
  bool visible = true;
  bool rightAxis = false;
  QList<bool> emphasised;  ///< optional, per point: drawn hollow/crossed (switched-off points, chosen model)
  QStringList pointLabels; ///< optional, per point: first line of the hover text (e.g. a model name)
};

struct PlotAxis {
  QString title;                          ///< with its unit: "Sensor angle (°)"
  bool logarithmic = false;               ///< values ≤ 0 are left out; PlotView says how many
  std::optional<double> minimum, maximum; ///< fixed range; otherwise data range and a 5 % margin
  std::optional<double> tickStep;         ///< e.g. 45 for angles
};

/// A straight line across the plot, e.g. a limit or a target; may be dragged.
struct PlotGuide {
  QString id;
  QString label;         ///< shown at the line together with its value
  bool vertical = false; ///< vertical: at an x value; otherwise at a y value
  double value = 0.0;
  bool draggable = false;
  SeriesColor color = SeriesColor::Muted;
  QString unit; ///< appended to the value in the label
};

struct PlotSpec {
  QString title;
  PlotAxis x, y;
  std::optional<PlotAxis> right; ///< second y axis
  QList<PlotSeries> series;
  QList<PlotGuide> guides;
  QString note;       ///< one line under the plot: what was left out, how it was made
  bool polar = false; ///< polar ring: x is the angle in degrees (0 at the top, clockwise), y the radius
};

} // namespace straightedge::gui
