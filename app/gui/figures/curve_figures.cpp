#include "app/gui/figures/curve_figures.h"

#include "app/gui/figures/figure_parts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace straightedge::gui {

namespace {

const QString curveTitle = QStringLiteral("Correction curve");
const QString correctionAxis = QStringLiteral("Correction (°)");

/// Grid angles over `turns` turns, the last one closing the turn.
QList<double> gridAngles(int turns = 1) {
  QList<double> angles;
  angles.reserve(angle::gridSize * turns + 1);
  for (int i = 0; i <= angle::gridSize * turns; ++i) {
    angles.append(i * 360.0 / angle::gridSize);
  }
  return angles;
}

QString curveNote(const angle::CorrectionCurve& curve, Eigen::Index points) {
  const QString made = curve.method == angle::CurveMethod::Regress
                           ? QStringLiteral("Least squares with %1 harmonics").arg(curve.harmonics)
                           : QStringLiteral("Periodic cubic spline");
  return QStringLiteral("%1 through %2 points; leave-one-out error %3 rms, %4 at most")
      .arg(made)
      .arg(points)
      .arg(degrees(curve.leaveOneOutRmsDeg, 3), degrees(curve.leaveOneOutMaxDeg, 3));
}

PlotSeries recordedPoints(const QList<double>& x, const QList<double>& y) {
  PlotSeries points;
  points.name = QStringLiteral("Recorded points");
  points.style = SeriesStyle::Points;
  points.color = SeriesColor::Muted;
  points.x = x;
  points.y = y;
  return points;
}

} // namespace

PlotSpec projectionFigure(const angle::AlignedSweep& aligned, const angle::CorrectionCurve& curve) {
  PlotSpec spec;
  spec.title = QStringLiteral("Encoder angle on the grid of sensor angles");
  spec.x = turnAxis(readingTitle(aligned.direction));
  spec.y = dataAxis(QStringLiteral("Encoder angle (°)"));
  spec.y.tickStep = 45.0;
  PlotSeries projection;
  projection.name = QStringLiteral("Projection");
  projection.color = SeriesColor::First;
  projection.x = gridAngles();
  projection.y.reserve(projection.x.size());
  for (int i = 0; i <= angle::gridSize; ++i) {
    projection.y.append(projection.x[i] + curve.gridDeg[i % angle::gridSize]);
  }
  spec.series = {projection,
                 recordedPoints(toList(aligned.readingDeg), toList(aligned.readingDeg + aligned.correctionDeg))};
  spec.note = curveNote(curve, aligned.readingDeg.size());
  return spec;
}

PlotSpec correctionCurveFigure(const angle::AlignedSweep& aligned, const angle::CorrectionCurve& curve) {
  PlotSpec spec;
  spec.title = curveTitle;
  spec.x = turnAxis(readingTitle(aligned.direction));
  spec.y = dataAxis(correctionAxis);
  PlotSeries line;
  line.name = curveTitle;
  line.color = SeriesColor::Reference;
  line.x = gridAngles();
  line.y = toList(curve.gridDeg);
  line.y.append(curve.gridDeg[0]);
  spec.series = {line, recordedPoints(toList(aligned.readingDeg), toList(aligned.correctionDeg))};
  spec.note = curveNote(curve, aligned.readingDeg.size());
  return spec;
}

PlotSpec repeatedCurveFigure(const angle::CorrectionCurve& curve, angle::SensorDirection direction, int turns,
                             int count) {
  PlotSpec spec;
  spec.title = QStringLiteral("Correction curve over %1 turns").arg(turns);
  spec.x.title = readingTitle(direction);
  spec.x.minimum = 0.0;
  spec.x.maximum = 360.0 * turns;
  spec.x.tickStep = turns > 2 ? 180.0 : 90.0;
  spec.y = dataAxis(correctionAxis);
  PlotSeries line;
  line.name = curveTitle;
  line.color = SeriesColor::Reference;
  line.x = gridAngles(turns);
  line.y.reserve(line.x.size());
  for (int i = 0; i <= angle::gridSize * turns; ++i) {
    line.y.append(curve.gridDeg[i % angle::gridSize]);
  }
  spec.series.append(line);
  std::vector<angle::HarmonicTerm> harmonics = curveHarmonics(curve);
  std::ranges::sort(harmonics, std::ranges::greater{}, &angle::HarmonicTerm::amplitudeDeg);
  const double mean = curve.gridDeg.mean();
  constexpr int stepsPerTurn = 720;
  for (std::size_t i = 0; i < std::min(harmonics.size(), static_cast<std::size_t>(std::max(count, 0))); ++i) {
    const angle::HarmonicTerm& term = harmonics[i];
    PlotSeries wave;
    wave.name = QStringLiteral("Harmonic %1").arg(term.order);
    wave.color = seriesColor(static_cast<int>(i));
    wave.dashed = true;
    for (int k = 0; k <= stepsPerTurn * turns; ++k) {
      const double x = k * 360.0 / stepsPerTurn;
      wave.x.append(x);
      wave.y.append(mean + term.amplitudeDeg * std::cos(term.order * x * std::numbers::pi / 180.0 + term.phaseRad));
    }
    spec.series.append(wave);
  }
  spec.note = QStringLiteral("Harmonics are drawn about the mean correction of %1").arg(degrees(mean));
  return spec;
}

std::vector<angle::HarmonicTerm> curveHarmonics(const angle::CorrectionCurve& curve, int count) {
  const int resolved = std::min(count, curve.resolvableHarmonics);
  if (resolved < 1) {
    return {};
  }
  const Result<angle::Model> model = angle::fitModel(
      curve, {.kind = angle::ModelKind::Harmonic, .size = resolved, .method = angle::FitMethod::Ordered, .bits = {}});
  return model ? std::get<angle::HarmonicModel>(model->body).terms : std::vector<angle::HarmonicTerm>{};
}

namespace {

PlotAxis harmonicAxis(std::size_t count) {
  PlotAxis axis;
  axis.title = QStringLiteral("Harmonic");
  axis.minimum = 0.5;
  axis.maximum = static_cast<double>(std::max(count, std::size_t{1})) + 0.5;
  axis.tickStep = count > 24 ? 4.0 : count > 8 ? 2.0 : 1.0;
  return axis;
}

PlotSeries harmonicBars(const std::vector<angle::HarmonicTerm>& harmonics, SeriesColor color,
                        double (*value)(const angle::HarmonicTerm&)) {
  PlotSeries bars;
  bars.style = SeriesStyle::Bars;
  bars.color = color;
  for (const angle::HarmonicTerm& term : harmonics) {
    bars.x.append(term.order);
    bars.y.append(value(term));
    bars.pointLabels.append(QStringLiteral("Harmonic %1").arg(term.order));
  }
  return bars;
}

} // namespace

PlotSpec harmonicAmplitudesFigure(const std::vector<angle::HarmonicTerm>& harmonics) {
  PlotSpec spec = emptyFigure(QStringLiteral("Amplitudes of the harmonics"), harmonicAxis(harmonics.size()),
                              dataAxis(QStringLiteral("Amplitude (°)")), {});
  spec.y.logarithmic = true;
  spec.series.append(
      harmonicBars(harmonics, SeriesColor::First, [](const angle::HarmonicTerm& term) { return term.amplitudeDeg; }));
  if (!harmonics.empty()) {
    const auto largest = std::ranges::max_element(harmonics, {}, &angle::HarmonicTerm::amplitudeDeg);
    spec.note = QStringLiteral("Largest: harmonic %1 with %2").arg(largest->order).arg(degrees(largest->amplitudeDeg));
  } else {
    spec.note = QStringLiteral("No harmonics: the points resolve none.");
  }
  return spec;
}

PlotSpec harmonicPhasesFigure(const std::vector<angle::HarmonicTerm>& harmonics) {
  PlotSpec spec = emptyFigure(QStringLiteral("Phases of the harmonics"), harmonicAxis(harmonics.size()),
                              dataAxis(QStringLiteral("Phase (rad)")), {});
  spec.y.minimum = -3.5;
  spec.y.maximum = 3.5;
  spec.y.tickStep = 1.0;
  spec.series.append(
      harmonicBars(harmonics, SeriesColor::Second, [](const angle::HarmonicTerm& term) { return term.phaseRad; }));
  spec.note = QStringLiteral("Term k is amplitude · cos(k · sensor angle + phase)");
  return spec;
}

} // namespace straightedge::gui
