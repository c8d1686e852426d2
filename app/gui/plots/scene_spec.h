// What a three-dimensional picture shows, as plain data: heights over a grid, directions of axes, directions covered.
#pragma once

#include "app/gui/plots/plot_spec.h"

#include <QList>
#include <QString>

#include <array>
#include <optional>
#include <utility>
#include <variant>

namespace straightedge::gui {

enum class SurfaceColors : std::uint8_t {
  Sequential,        ///< viridis over the range of heights
  DivergingFromZero, ///< blue below zero, red above, grey at zero; equally far both ways
};

/// Heights over a grid, with a colour bar.
struct SurfaceSpec {
  QString title;
  QString xTitle, yTitle, zTitle; ///< with units: "Field (T)"; zTitle is the colour bar's as well
  QList<double> x, y;             ///< ascending, at least two each
  QList<double> z;                ///< x.size() · y.size() values, row by row of equal y; NaN leaves a hole
  SurfaceColors colors = SurfaceColors::Sequential;
  std::optional<std::pair<double, double>> zRange; ///< of height axis and colours; without one that of z

  bool isEmpty() const { return x.size() < 2 || y.size() < 2 || z.size() != x.size() * y.size(); }
};

/// An axis as it should point and as it was found to point; lengths do not matter.
struct MeasuredDirection {
  QString label;        ///< beside the tip: "x, tilted by 0.86°"
  QString nominalLabel; ///< at the end of the thin axis: "package x"
  SeriesColor color = SeriesColor::First;
  std::array<double, 3> nominal = {1.0, 0.0, 0.0};
  std::array<double, 3> measured = {1.0, 0.0, 0.0};
};

/// Arrows from one origin against thin nominal axes.
struct DirectionsSpec {
  QString title;
  QString note; ///< below the title: the factor, the angles between the axes
  QList<MeasuredDirection> directions;
  double exaggeration = 1.0; ///< the angle out of the nominal direction is drawn this many times as large

  bool isEmpty() const { return directions.isEmpty(); }
};

/// A direction that was measured, or was to be.
struct SphereMark {
  QString name;   ///< "+x"
  QString detail; ///< "90 rows, 0.5 to 1.5 T", "not measured"
  std::array<double, 3> direction = {1.0, 0.0, 0.0};
  bool covered = false;
};

/// Marks on a sphere: filled caps where covered, rings where not.
struct SphereSpec {
  QString title;
  QString note; ///< below the title
  QList<SphereMark> marks;

  bool isEmpty() const { return marks.isEmpty(); }
};

using SceneSpec = std::variant<SurfaceSpec, DirectionsSpec, SphereSpec>;

QString sceneTitle(const SceneSpec& spec);
/// What a person who does not see the picture is told.
QString sceneInWords(const SceneSpec& spec);
bool isEmptyScene(const SceneSpec& spec);

} // namespace straightedge::gui
