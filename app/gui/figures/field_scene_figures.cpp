#include "app/gui/figures/field_scene_figures.h"

#include "app/gui/figures/field_axis_figures.h"
#include "app/gui/figures/field_figure_parts.h"
#include "core/field/names.h"

#include <algorithm>
#include <cmath>

namespace straightedge::gui {

namespace {

/// "+x"; with a proper minus sign.
QString orientationText(field::Orientation orientation) {
  const std::string_view name = field::orientationName(orientation);
  return QString::fromLatin1(name.data(), static_cast<qsizetype>(name.size())).replace(QLatin1Char('-'), QChar(0x2212));
}

QString coverageText(const field::OrientationCoverage& covered) {
  if (covered.rows == 0) {
    return QStringLiteral("not measured");
  }
  const double low = std::min(std::abs(covered.smallestT), std::abs(covered.largestT));
  const double high = std::max(std::abs(covered.smallestT), std::abs(covered.largestT));
  const QString rows = covered.rows == 1 ? QStringLiteral("1 row, ") : QStringLiteral("%1 rows, ").arg(covered.rows);
  const QString from = QString::number(low, 'g', 3); // no digits that say nothing: "0.5 to 1.5"
  const QString to = QString::number(high, 'g', 3);
  return rows + (from == to ? to : from + QStringLiteral(" to ") + to) + QStringLiteral(" T");
}

/// The largest of 1, 2, 5, 10, … that draws this tilt as no more than 25°; at least 1.
double exaggerationFor(double largestTiltDeg) {
  constexpr double mostDrawnDeg = 25.0;
  if (!(largestTiltDeg > 1e-6)) {
    return 1.0;
  }
  const double most = mostDrawnDeg / largestTiltDeg;
  const double decade = std::pow(10.0, std::floor(std::log10(most)));
  const double factor = most >= 5.0 * decade ? 5.0 * decade : most >= 2.0 * decade ? 2.0 * decade : decade;
  return std::max(1.0, factor);
}

QString degreesText(double degrees, int decimals) {
  return QString::number(degrees, 'f', decimals) + QStringLiteral("°");
}

} // namespace

std::vector<field::OrientationCoverage> orientationsCovered(const field::Campaign& campaign,
                                                            const std::vector<bool>& enabled) {
  std::vector<field::OrientationCoverage> covered(6);
  for (std::size_t place = 0; place < covered.size(); ++place) {
    covered[place].orientation = static_cast<field::Orientation>(place);
  }
  for (std::size_t i = 0; i < campaign.rows.size(); ++i) {
    const field::CampaignRow& row = campaign.rows[i];
    const bool on = i >= enabled.size() || enabled[i];
    if (row.step != field::CampaignStep::Orientation || !row.orientation || !row.locked || !on ||
        !std::isfinite(row.referenceT)) {
      continue;
    }
    field::OrientationCoverage& each = covered[static_cast<std::size_t>(*row.orientation)];
    const double fieldT = std::abs(row.referenceT);
    each.smallestT = each.rows == 0 ? fieldT : std::min(each.smallestT, fieldT);
    each.largestT = each.rows == 0 ? fieldT : std::max(each.largestT, fieldT);
    ++each.rows;
  }
  return covered;
}

SphereSpec orientationSphere(const std::vector<field::OrientationCoverage>& covered) {
  SphereSpec spec;
  const auto measured =
      std::ranges::count_if(covered, [](const field::OrientationCoverage& each) { return each.rows > 0; });
  if (measured == 0) {
    spec.title = QStringLiteral("No orientations were measured");
    return spec;
  }
  spec.title = QStringLiteral("Orientations covered: directions of the package that pointed along the field");
  spec.note = QStringLiteral("%1 of %2 directions were measured").arg(measured).arg(covered.size());
  for (const field::OrientationCoverage& each : covered) {
    const auto place = static_cast<std::size_t>(each.orientation);
    SphereMark mark;
    mark.name = orientationText(each.orientation);
    mark.detail = coverageText(each);
    mark.direction = {0.0, 0.0, 0.0};
    mark.direction.at(place / 2) = place % 2 == 0 ? 1.0 : -1.0;
    mark.covered = each.rows > 0;
    spec.marks.append(mark);
  }
  return spec;
}

DirectionsSpec axisDirections(const Eigen::Matrix3d& matrix) {
  DirectionsSpec spec;
  const Eigen::Vector3d tilts = axisTiltsDeg(matrix);
  const Eigen::Vector3d between = anglesBetweenAxesDeg(matrix);
  spec.exaggeration = exaggerationFor(tilts.maxCoeff());
  spec.title = QStringLiteral("Directions of the probe's axes against the package");
  for (const field::Axis axis : field::allAxes) {
    const auto place = static_cast<Eigen::Index>(field::indexOf(axis));
    MeasuredDirection direction;
    direction.color = axisColor(axis);
    direction.label = axisLetter(axis) + QStringLiteral(", tilted by ") + degreesText(tilts[place], 2);
    direction.nominalLabel = QStringLiteral("package ") + axisLetter(axis);
    direction.nominal = {0.0, 0.0, 0.0};
    direction.nominal.at(static_cast<std::size_t>(place)) = 1.0;
    direction.measured = {matrix(place, 0), matrix(place, 1), matrix(place, 2)};
    spec.directions.append(direction);
  }
  spec.note = QStringLiteral("Tilts are drawn %1 times as large; between the axes: x and y %2, x and z %3, y and z %4")
                  .arg(QString::number(spec.exaggeration, 'g', 6), degreesText(between[0], 2),
                       degreesText(between[1], 2), degreesText(between[2], 2));
  if (spec.exaggeration <= 1.0) {
    spec.note.replace(QStringLiteral("Tilts are drawn 1 times as large"),
                      QStringLiteral("Tilts are drawn as they are"));
  }
  return spec;
}

} // namespace straightedge::gui
