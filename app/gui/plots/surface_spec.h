// What a three-dimensional plot shows, as plain data: heights over a grid.
#pragma once

#include <QList>
#include <QString>

namespace straightedge::gui {

struct SurfaceSpec {
  QString title;
  QString xTitle, yTitle, zTitle; ///< with units: "Field (T)"
  QList<double> x, y;             ///< ascending, at least two each
  QList<double> z;                ///< x.size() · y.size() values, row by row of equal y; NaN leaves a hole

  bool isEmpty() const { return x.size() < 2 || y.size() < 2 || z.size() != x.size() * y.size(); }
};

} // namespace straightedge::gui
