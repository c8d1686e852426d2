#include "app/gui/figures/verification_figures.h"

#include "app/gui/figures/figure_parts.h"
#include "core/angle/angles.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace straightedge::gui {

namespace {

PlotSeries errorSeries(const QString& name, const std::vector<double>& encoderDeg, const std::vector<double>& errorDeg,
                       SeriesColor color) {
  std::vector<std::pair<double, double>> points;
  points.reserve(encoderDeg.size());
  for (std::size_t i = 0; i < encoderDeg.size(); ++i) {
    points.emplace_back(angle::wrap360(encoderDeg[i]), errorDeg[i]);
  }
  std::ranges::sort(points);
  PlotSeries series;
  series.name = name;
  series.color = color;
  series.style = points.size() > 200 ? SeriesStyle::Points : SeriesStyle::LineAndPoints;
  for (const auto& [x, y] : points) {
    series.x.append(x);
    series.y.append(y);
  }
  return series;
}

void addLimits(PlotSpec& spec, double limitDeg) {
  for (const double value : {limitDeg, -limitDeg}) {
    PlotGuide guide;
    guide.id = value > 0.0 ? QStringLiteral("limit") : QStringLiteral("lower limit");
    guide.label = value > 0.0 ? QStringLiteral("Limit") : QString();
    guide.value = value;
    guide.color = SeriesColor::Bad;
    guide.unit = QStringLiteral("°");
    spec.guides.append(guide);
  }
}

PlotSpec encoderSpec(const QString& title, const QString& error) {
  PlotSpec spec;
  spec.title = title;
  spec.x = turnAxis(QStringLiteral("Encoder angle (°)"));
  spec.y.title = error;
  return spec;
}

} // namespace

PlotSpec beforeAfterFigure(const angle::VerificationReport& report) {
  PlotSpec spec =
      encoderSpec(QStringLiteral("Error before and after correction"), QStringLiteral("Error after correction (°)"));
  PlotSeries before =
      errorSeries(QStringLiteral("Before"), report.encoderDeg, report.errorBeforeDeg, SeriesColor::Muted);
  const PlotSeries after =
      errorSeries(QStringLiteral("After"), report.encoderDeg, report.errorAfterDeg, SeriesColor::First);
  // an uncorrected error many times the limit would flatten what matters here: it gets an axis of its own
  constexpr double sharedAxisFactor = 5.0;
  if (report.maxErrorBeforeDeg > sharedAxisFactor * std::max(report.maxErrorDeg, report.limitDeg)) {
    before.rightAxis = true;
    before.name = QStringLiteral("Before (right axis)");
    PlotAxis right;
    right.title = QStringLiteral("Error before correction (°)");
    spec.right = right;
  } else {
    spec.y.title = QStringLiteral("Error (°)");
  }
  const double reach = 1.25 * std::max(report.maxErrorDeg, report.limitDeg);
  if (before.rightAxis) {
    spec.y.minimum = -reach;
    spec.y.maximum = reach;
  }
  spec.series = {before, after};
  addLimits(spec, report.limitDeg);
  spec.note = QStringLiteral("Largest error: %1 before, %2 after")
                  .arg(degrees(report.maxErrorBeforeDeg), degrees(report.maxErrorDeg));
  return spec;
}

PlotSpec correctedErrorFigure(const angle::VerificationReport& report) {
  PlotSpec spec = encoderSpec(QStringLiteral("Error after correction"), QStringLiteral("Error after correction (°)"));
  PlotSeries after = errorSeries(QStringLiteral("After"), report.encoderDeg, report.errorAfterDeg, SeriesColor::First);
  spec.series = {after};
  // Within these lines a point keeps the limit whatever its uncertainty; none where the uncertainty eats up the limit.
  const double beyondDoubtDeg = report.limitDeg - report.expandedUncertaintyDeg;
  if (report.expandedUncertaintyDeg > 0.0 && beyondDoubtDeg > 0.0) {
    PlotSeries line;
    line.color = SeriesColor::Muted;
    line.dashed = true;
    line.name = QStringLiteral("Limit less the expanded uncertainty (95 %)");
    for (const double sign : {1.0, -1.0}) {
      PlotSeries edge = line;
      edge.x = {0.0, 360.0};
      edge.y = {sign * beyondDoubtDeg, sign * beyondDoubtDeg};
      spec.series.append(edge);
      line.name.clear();
    }
  }
  const double reach = 1.15 * (std::max(report.maxErrorDeg, report.limitDeg) + report.expandedUncertaintyDeg);
  spec.y.minimum = -reach;
  spec.y.maximum = reach;
  addLimits(spec, report.limitDeg);
  spec.note = QStringLiteral("Largest error %1, %2 rms over %3 points")
                  .arg(degrees(report.maxErrorDeg), degrees(report.rmsErrorDeg))
                  .arg(report.points);
  return spec;
}

} // namespace straightedge::gui
