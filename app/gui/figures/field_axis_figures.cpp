#include "app/gui/figures/field_axis_figures.h"

#include "app/gui/figures/field_figure_parts.h"
#include "app/gui/figures/figure_parts.h"
#include "core/field/names.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace straightedge::gui {

namespace {

constexpr double degreesPerRadian = 180.0 / std::numbers::pi;

/// By atan2 of both products: an arc cosine loses half of its digits near 0.
double angleBetweenDeg(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const Eigen::Vector3d cross(a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
                              a.x() * b.y() - a.y() * b.x());
  return degreesPerRadian * std::atan2(cross.norm(), a.dot(b));
}

} // namespace

Eigen::Vector3d anglesBetweenAxesDeg(const Eigen::Matrix3d& matrix) {
  const Eigen::Vector3d x = matrix.row(0);
  const Eigen::Vector3d y = matrix.row(1);
  const Eigen::Vector3d z = matrix.row(2);
  return {angleBetweenDeg(x, y), angleBetweenDeg(x, z), angleBetweenDeg(y, z)};
}

Eigen::Vector3d axisTiltsDeg(const Eigen::Matrix3d& matrix) {
  Eigen::Vector3d tilts;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    tilts[axis] = angleBetweenDeg(matrix.row(axis), Eigen::Vector3d::Unit(axis));
  }
  return tilts;
}

PlotSpec axisTiltsFigure(const Eigen::Matrix3d& matrix) {
  PlotSpec spec;
  spec.title = QStringLiteral("Probe axes seen along their package axes");
  spec.x = dataAxis(QStringLiteral("Tilt towards the next axis (°)"));
  spec.y = dataAxis(QStringLiteral("Tilt towards the one after (°)"));
  double reach = 0.0;
  const Eigen::Vector3d tilts = axisTiltsDeg(matrix);
  QStringList figures;
  for (const field::Axis axis : field::allAxes) {
    const auto own = static_cast<Eigen::Index>(field::indexOf(axis));
    const Eigen::Index next = (own + 1) % 3;
    const Eigen::Index after = (own + 2) % 3;
    const double right = degreesPerRadian * std::atan2(matrix(own, next), matrix(own, own));
    const double up = degreesPerRadian * std::atan2(matrix(own, after), matrix(own, own));
    reach = std::max({reach, std::abs(right), std::abs(up)});
    PlotSeries series =
        lineSeries(QStringLiteral("Axis %1: to the right %2, up %3")
                       .arg(axisLetter(axis), axisLetter(field::allAxes.at(static_cast<std::size_t>(next))),
                            axisLetter(field::allAxes.at(static_cast<std::size_t>(after)))),
                   axisColor(axis), {0.0, right}, {0.0, up});
    series.style = SeriesStyle::LineAndPoints;
    spec.series.append(series);
    figures << axisLetter(axis) + QLatin1Char(' ') + peopleNumber(tilts[own]) + QStringLiteral("°");
  }
  constexpr double room = 1.2;
  spec.y.minimum = -room * reach;
  spec.y.maximum = room * reach;
  spec.x.minimum = -2.0 * room * reach; // about twice as wide as high: a degree is as long in both directions
  spec.x.maximum = 2.0 * room * reach;
  spec.note = QStringLiteral("Tilts: ") + figures.join(QStringLiteral(", "));
  return spec;
}

} // namespace straightedge::gui
