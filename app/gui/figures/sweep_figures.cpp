#include "app/gui/figures/sweep_figures.h"

#include "app/gui/figures/figure_parts.h"
#include "core/angle/angles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace straightedge::gui {

using angle::wrap180;
using angle::wrap360;

namespace {

constexpr double gapInLine = std::numeric_limits<double>::quiet_NaN();
/// Above this many points a joining line and markers would hide each other; points alone say more.
constexpr std::size_t joinedPointsLimit = 2000;

const QString encoderTitle = QStringLiteral("Encoder angle (°)");
const QString sensorTitle = QStringLiteral("Sensor angle (°)");

struct RowPoint {
  double x = 0.0;
  double y = 0.0;
  std::size_t row = 0;
  int direction = 1;
  bool enabled = true;
};

int directionOf(const angle::Sweep& sweep, std::size_t row) {
  return sweep.direction.empty() ? 1 : sweep.direction[row];
}

void addPoints(RowFigure& figure, const std::vector<RowPoint>& points, int direction, const QString& name,
               SeriesColor color) {
  PlotSeries series;
  series.name = name;
  series.style = SeriesStyle::Points;
  series.color = color;
  std::vector<std::size_t> rows;
  bool anyOff = false;
  for (const RowPoint& point : points) {
    if (direction != 0 && point.direction != direction) {
      continue;
    }
    series.x.append(point.x);
    series.y.append(point.y);
    series.emphasised.append(!point.enabled);
    anyOff = anyOff || !point.enabled;
    rows.push_back(point.row);
  }
  if (!anyOff) {
    series.emphasised.clear();
  }
  figure.spec.series.append(series);
  figure.rows.push_back(std::move(rows));
}

/// Joins enabled points in order of x; breaks where y jumps by more than `breakAbove`.
void addJoiningLine(RowFigure& figure, std::vector<RowPoint> points, double breakAbove) {
  std::erase_if(points, [](const RowPoint& point) { return !point.enabled; });
  if (points.size() < 2 || points.size() > joinedPointsLimit) {
    return;
  }
  std::ranges::sort(points, {}, &RowPoint::x);
  PlotSeries line;
  line.style = SeriesStyle::Line;
  line.color = SeriesColor::Muted;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0 && std::abs(points[i].y - points[i - 1].y) > breakAbove) {
      line.x.append(points[i].x);
      line.y.append(gapInLine);
    }
    line.x.append(points[i].x);
    line.y.append(points[i].y);
  }
  figure.spec.series.append(line);
  figure.rows.emplace_back();
}

void addByDirection(RowFigure& figure, const std::vector<RowPoint>& points, double breakAbove) {
  const bool rising = std::ranges::any_of(points, [](const RowPoint& point) { return point.direction >= 0; });
  const bool falling = std::ranges::any_of(points, [](const RowPoint& point) { return point.direction < 0; });
  if (rising && falling) {
    addPoints(figure, points, 1, QStringLiteral("Rising"), SeriesColor::First);
    addPoints(figure, points, -1, QStringLiteral("Falling"), SeriesColor::Second);
  } else {
    addPoints(figure, points, 0, QStringLiteral("Readings"), SeriesColor::First);
    addJoiningLine(figure, points, breakAbove);
  }
}

QString countNote(std::size_t all, std::size_t off) {
  QString note = all == 1 ? QStringLiteral("1 reading") : QStringLiteral("%1 readings").arg(all);
  if (off > 0) {
    note += QStringLiteral(", %1 switched off").arg(off);
  }
  return note;
}

std::size_t switchedOff(const angle::Sweep& sweep) {
  return static_cast<std::size_t>(std::ranges::count(sweep.enabled, false));
}

/// Mean of angles on the circle; the constant about which an error is unwrapped.
double circularMeanDeg(const std::vector<double>& anglesDeg) {
  constexpr double radians = std::numbers::pi / 180.0;
  double cosine = 0.0;
  double sine = 0.0;
  for (const double value : anglesDeg) {
    cosine += std::cos(value * radians);
    sine += std::sin(value * radians);
  }
  return anglesDeg.empty() ? 0.0 : std::atan2(sine, cosine) / radians;
}

} // namespace

RowFigure sensorOverEncoderFigure(const angle::Sweep& sweep) {
  RowFigure figure;
  figure.spec.title = QStringLiteral("Sensor angle over encoder angle");
  figure.spec.x = turnAxis(encoderTitle);
  figure.spec.y = turnAxis(sensorTitle);
  std::vector<RowPoint> points;
  points.reserve(sweep.size());
  for (std::size_t row = 0; row < sweep.size(); ++row) {
    points.push_back({wrap360(sweep.encoderDeg[row]), wrap360(sweep.sensorDeg[row]), row, directionOf(sweep, row),
                      sweep.isEnabled(row)});
  }
  addByDirection(figure, points, 180.0);
  figure.spec.note = sweep.size() == 0 ? QStringLiteral("No readings yet: capture or import a sweep.")
                                       : countNote(sweep.size(), switchedOff(sweep));
  return figure;
}

RowFigure unwrappedFigure(const angle::AlignedSweep& aligned) {
  RowFigure figure;
  figure.spec.title = QStringLiteral("Sensor angle without wrap-around");
  figure.spec.x = turnAxis(encoderTitle);
  figure.spec.y = dataAxis(QStringLiteral("Unwrapped %1")
                               .arg(aligned.direction == angle::SensorDirection::Decreasing
                                        ? QStringLiteral("360° − sensor angle (°)")
                                        : QStringLiteral("sensor angle (°)")));
  figure.spec.y.tickStep = 45.0;
  std::vector<RowPoint> points;
  points.reserve(static_cast<std::size_t>(aligned.encoderDeg.size()));
  for (Eigen::Index i = 0; i < aligned.encoderDeg.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    // correction = encoder − reading is continuous over the turn, so encoder − correction is the reading unwrapped
    points.push_back({aligned.encoderDeg[i], aligned.encoderDeg[i] - aligned.correctionDeg[i],
                      at < aligned.row.size() ? aligned.row[at] : at, at < aligned.pass.size() ? aligned.pass[at] : 1,
                      true});
  }
  addByDirection(figure, points, 180.0);
  figure.spec.note = countNote(points.size(), 0);
  return figure;
}

RowFigure errorFigure(const angle::Sweep& sweep, angle::SensorDirection direction, ErrorAxis axis, ConstantPart part) {
  RowFigure figure;
  const bool overEncoder = axis == ErrorAxis::Encoder;
  figure.spec.title =
      overEncoder ? QStringLiteral("Angle error over encoder angle") : QStringLiteral("Angle error over sensor angle");
  figure.spec.x = turnAxis(overEncoder ? encoderTitle : sensorTitle);
  figure.spec.y = dataAxis(part == ConstantPart::Kept ? QStringLiteral("Error (°)")
                                                      : QStringLiteral("Error without constant part (°)"));
  std::vector<double> differences(sweep.size());
  std::vector<double> used;
  for (std::size_t row = 0; row < sweep.size(); ++row) {
    const double reading =
        direction == angle::SensorDirection::Decreasing ? 360.0 - sweep.sensorDeg[row] : sweep.sensorDeg[row];
    differences[row] = reading - sweep.encoderDeg[row];
    if (sweep.isEnabled(row)) {
      used.push_back(differences[row]);
    }
  }
  const double constant = circularMeanDeg(used);
  std::vector<RowPoint> points;
  points.reserve(sweep.size());
  const RowPoint* largest = nullptr;
  for (std::size_t row = 0; row < sweep.size(); ++row) {
    const double shape = wrap180(differences[row] - constant);
    points.push_back({wrap360(overEncoder ? sweep.encoderDeg[row] : sweep.sensorDeg[row]),
                      part == ConstantPart::Kept ? shape + constant : shape, row, directionOf(sweep, row),
                      sweep.isEnabled(row)});
    if (points.back().enabled && (largest == nullptr || std::abs(points.back().y) > std::abs(largest->y))) {
      largest = &points.back();
    }
  }
  addByDirection(figure, points, std::numeric_limits<double>::infinity());
  if (largest != nullptr) {
    figure.spec.note = QStringLiteral("Largest error %1 at %2; constant part %3")
                           .arg(degrees(largest->y), degrees(largest->x), degrees(constant));
  } else {
    figure.spec.note = QStringLiteral("No readings yet: capture or import a sweep.");
  }
  return figure;
}

PlotSpec liveSensorFigure() { return sensorOverEncoderFigure({}).spec; }

PlotSpec liveErrorFigure() {
  return errorFigure({}, angle::SensorDirection::Increasing, ErrorAxis::Encoder, ConstantPart::Kept).spec;
}

PlotSpec hysteresisFigure(const angle::Repeatability& passes) {
  const PlotAxis x = turnAxis(encoderTitle);
  const PlotAxis y = dataAxis(QStringLiteral("Deviation from the mean of both directions (°)"));
  const QString title = QStringLiteral("Hysteresis");
  if (passes.hysteresisDeg.empty()) {
    return emptyFigure(title, x, y, QStringLiteral("Hysteresis needs a sweep in both directions."));
  }
  PlotSpec spec = emptyFigure(title, x, y, {});
  PlotSeries rising;
  rising.name = QStringLiteral("Rising");
  rising.style = SeriesStyle::LineAndPoints;
  rising.x = toList(passes.encoderDeg);
  rising.y = toList(passes.hysteresisDeg); // half the difference is each direction's distance from the common mean
  PlotSeries falling = rising;
  falling.name = QStringLiteral("Falling");
  falling.color = SeriesColor::Second;
  for (double& value : falling.y) {
    value = -value;
  }
  spec.series = {rising, falling};
  if (passes.hysteresisMaxDeg && passes.hysteresisRmsDeg) {
    spec.note = QStringLiteral("Half difference: %1 at most, %2 rms")
                    .arg(degrees(*passes.hysteresisMaxDeg), degrees(*passes.hysteresisRmsDeg));
  }
  return spec;
}

PlotSpec coverageRingFigure(const std::vector<double>& plannedDeg, const std::vector<double>& doneDeg,
                            const std::vector<angle::CoverageGap>& gaps) {
  PlotSpec spec;
  spec.title = QStringLiteral("Coverage");
  spec.polar = true;
  spec.x = turnAxis(encoderTitle);
  spec.y.minimum = 0.0;
  spec.y.maximum = 1.2;
  const auto ring = [](const QString& name, const std::vector<double>& anglesDeg, SeriesColor color) {
    PlotSeries series;
    series.name = name;
    series.style = SeriesStyle::Points;
    series.color = color;
    for (const double value : anglesDeg) {
      series.x.append(wrap360(value));
      series.y.append(1.0);
    }
    return series;
  };
  spec.series.append(ring(QStringLiteral("Planned"), plannedDeg, SeriesColor::Muted));
  spec.series.append(ring(QStringLiteral("Measured"), doneDeg, SeriesColor::Good));
  PlotSeries arcs;
  arcs.name = gaps.empty() ? QString() : QStringLiteral("Gap");
  arcs.color = SeriesColor::Bad;
  for (const angle::CoverageGap& gap : gaps) {
    const int steps = std::max(2, static_cast<int>(std::ceil(gap.widthDeg)));
    for (int i = 0; i <= steps; ++i) {
      arcs.x.append(wrap360(gap.fromDeg + gap.widthDeg * i / steps));
      arcs.y.append(1.0);
    }
    arcs.x.append(gap.fromDeg);
    arcs.y.append(gapInLine);
  }
  spec.series.append(arcs);
  return spec;
}

} // namespace straightedge::gui
