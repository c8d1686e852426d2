#include "app/gui/figures/curve_figures.h"
#include "app/gui/figures/model_figures.h"
#include "tests/app/gui/figures/example_results.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace straightedge::gui {
namespace {

using testing::exampleRun;
using testing::valueOf;

double largest(const QList<double>& values) {
  double most = 0.0;
  for (const double value : values) {
    most = std::max(most, std::abs(value));
  }
  return most;
}

TEST(CorrectionCurveFigure, FollowsTheGridAndClosesTheTurn) {
  const angle::CalibrationRun run = exampleRun();
  const PlotSpec spec = correctionCurveFigure(run.aligned, run.curve);
  ASSERT_EQ(spec.series.size(), 2);
  const PlotSeries& line = spec.series[0];
  ASSERT_EQ(line.x.size(), 4097);
  EXPECT_EQ(line.x.back(), 360.0);
  EXPECT_EQ(line.y.front(), line.y.back());
  const auto at = static_cast<qsizetype>(std::lround(137.46 / 360.0 * 4096.0));
  EXPECT_NEAR(line.y[at], 213.75 - 137.46, 0.05);
  EXPECT_EQ(spec.series[1].x.size(), 32);
  EXPECT_EQ(spec.y.title, "Correction (°)");
}

TEST(ProjectionFigure, GivesTheEncoderAngleOfEveryGridAngle) {
  const angle::CalibrationRun run = exampleRun();
  const PlotSpec spec = projectionFigure(run.aligned, run.curve);
  const PlotSeries& line = spec.series[0];
  ASSERT_EQ(line.x.size(), 4097);
  for (const int i : {0, 1000, 4095}) {
    EXPECT_DOUBLE_EQ(line.y[i], i * 360.0 / 4096.0 + run.curve.gridDeg[i]);
  }
  EXPECT_NEAR(line.y.back() - line.y.front(), 360.0, 1e-9);
}

TEST(RepeatedCurve, ShowsThreeTurnsWithTheLargestHarmonicsFirst) {
  const angle::CalibrationRun run = exampleRun();
  const PlotSpec spec = repeatedCurveFigure(run.curve, run.aligned.direction);
  ASSERT_EQ(spec.series.size(), 4);
  EXPECT_EQ(spec.series[0].x.back(), 1080.0);
  EXPECT_EQ(spec.series[0].y[100], spec.series[0].y[100 + 2 * 4096]);
  EXPECT_EQ(spec.series[1].name, "Harmonic 1");
  EXPECT_EQ(spec.series[2].name, "Harmonic 2");
  const auto [low, high] = std::ranges::minmax(spec.series[1].y);
  EXPECT_NEAR((high - low) / 2.0, 8.154, 0.001);
  EXPECT_NEAR((high + low) / 2.0, 89.82, 0.01);
}

TEST(HarmonicFigures, HaveABarPerHarmonicWithUnits) {
  const angle::CalibrationRun run = exampleRun();
  const std::vector<angle::HarmonicTerm> harmonics = curveHarmonics(run.curve);
  ASSERT_EQ(harmonics.size(), 16U);
  const PlotSpec amplitudes = harmonicAmplitudesFigure(harmonics);
  EXPECT_EQ(amplitudes.series[0].style, SeriesStyle::Bars);
  EXPECT_NEAR(amplitudes.series[0].y[0], 8.154400908, 1e-6);
  EXPECT_NEAR(amplitudes.series[0].y[8], 0.042614052, 1e-6);
  EXPECT_EQ(amplitudes.y.title, "Amplitude (°)");
  EXPECT_TRUE(amplitudes.note.startsWith("Largest: harmonic 1"));
  const PlotSpec phases = harmonicPhasesFigure(harmonics);
  EXPECT_NEAR(phases.series[0].y[1], -1.399155316, 1e-6);
  EXPECT_EQ(phases.y.title, "Phase (rad)");
}

TEST(ModelSeries, DrawsTablesAsStepsAndSegmentsByTheirValues) {
  const angle::CalibrationRun run = exampleRun();
  const PlotSeries harmonic = modelSeries(run.result.models[0], SeriesColor::First);
  EXPECT_EQ(harmonic.style, SeriesStyle::Line);
  EXPECT_NEAR(harmonic.y[360], run.result.models[0].correctionDeg(90.0), 1e-12);
  const PlotSeries linear = modelSeries(run.result.models[1], SeriesColor::Second);
  ASSERT_EQ(linear.x.size(), 33);
  EXPECT_EQ(linear.x[1], 11.25);
  EXPECT_EQ(linear.y.front(), linear.y.back());
  EXPECT_NEAR(linear.y[0], 97.9529486351, 1e-6);
  const PlotSeries table = modelSeries(run.result.models[2], SeriesColor::Third);
  EXPECT_EQ(table.style, SeriesStyle::Steps);
  ASSERT_EQ(table.x.size(), 65);
  EXPECT_EQ(table.y[64], table.y[63]); // the last entry serves up to 360°
  EXPECT_EQ(table.name, "64 table entries");
}

TEST(CurveWithModels, DrawsWhatIsThere) {
  const angle::CalibrationRun run = exampleRun();
  const PlotSpec all = curveWithModelsFigure(run.result.models, &run.aligned, &run.curve, run.aligned.direction);
  ASSERT_EQ(all.series.size(), 5);
  EXPECT_EQ(all.series[1].name, "Correction curve");
  EXPECT_EQ(all.series[2].name, "4 harmonics");
  const PlotSpec models = curveWithModelsFigure(run.result.models, nullptr, nullptr, run.aligned.direction);
  EXPECT_EQ(models.series.size(), 3);
}

TEST(Residuals, HaveTheErrorsThatTheCalibrationStates) {
  const angle::CalibrationRun run = exampleRun();
  const PlotSpec curve = residualFigure(run.result.models, run.curve, run.aligned.direction);
  const PlotSpec points = pointResidualFigure(run.result.models, run.aligned);
  ASSERT_EQ(curve.series.size(), 3);
  ASSERT_EQ(points.series.size(), 3);
  for (int i = 0; i < 3; ++i) {
    const angle::ModelErrors& errors = run.result.models[static_cast<std::size_t>(i)].errors;
    EXPECT_NEAR(largest(curve.series[i].y), errors.maxCurveDeg, 1e-9);
    EXPECT_NEAR(largest(points.series[i].y), errors.maxPointsDeg, 1e-9);
    EXPECT_TRUE(std::ranges::is_sorted(points.series[i].x));
  }
}

TEST(Residuals, CountNoWholeTurnAsAnError) {
  const angle::CalibrationRun run = exampleRun();
  angle::AlignedSweep turned = run.aligned;
  turned.correctionDeg[3] += 360.0;
  const PlotSpec expected = pointResidualFigure(run.result.models, run.aligned);
  const PlotSpec actual = pointResidualFigure(run.result.models, turned);
  EXPECT_NEAR(largest(actual.series[0].y), largest(expected.series[0].y), 1e-9);
}

TEST(GrowingFamilies, LeaveLessWithEverySize) {
  const angle::CalibrationRun run = exampleRun();
  const PlotSpec harmonics = growingFamilyFigure(GrowingFamily::Harmonics, run.aligned, run.curve);
  ASSERT_EQ(harmonics.series.size(), 5); // 1, 2, 4, 8, 16: the 32 points resolve 16
  EXPECT_EQ(harmonics.series[3].name, "8 harmonics");
  for (int i = 1; i < 5; ++i) {
    EXPECT_LT(largest(harmonics.series[i].y), largest(harmonics.series[i - 1].y));
  }
  const PlotSpec segments = growingFamilyFigure(GrowingFamily::Segments, run.aligned, run.curve);
  ASSERT_EQ(segments.series.size(), 4);
  EXPECT_LT(largest(segments.series[3].y), 0.25 * largest(segments.series[0].y));
  const PlotSpec entries = growingFamilyFigure(GrowingFamily::TableEntries, run.aligned, run.curve);
  ASSERT_EQ(entries.series.size(), 4);
  EXPECT_EQ(entries.series[0].x.size(), 32);
  EXPECT_TRUE(entries.note.contains("256: "));
}

TEST(LinearMethods, ComparesThreeWithTheCurve) {
  const angle::CalibrationRun run = exampleRun();
  const PlotSpec spec = linearMethodsFigure(run.curve, 16, run.aligned.direction);
  ASSERT_EQ(spec.series.size(), 4);
  EXPECT_EQ(spec.series[0].color, SeriesColor::Reference);
  EXPECT_EQ(spec.series[1].y[0], run.curve.gridDeg[0]); // on the curve
  EXPECT_NE(spec.series[2].y[0], run.curve.gridDeg[0]);
  EXPECT_TRUE(spec.note.contains("on-curve") && spec.note.contains("least-squares") && spec.note.contains("minimax"));
}

TEST(TableSteps, LieOverTheCurve) {
  const angle::CalibrationRun run = exampleRun();
  const PlotSpec spec = tableStepsFigure(run.curve, 64, run.aligned.direction);
  ASSERT_EQ(spec.series.size(), 2);
  EXPECT_EQ(spec.series[1].style, SeriesStyle::Steps);
  EXPECT_NEAR(spec.series[1].y[0], 98.0584231815, 1e-6);
}

TEST(AngleFigures, CoverEveryFigureOfTheMethodAndOnlyWhatIsThere) {
  const QList<NamedFigure> all = angleFigures(testing::exampleResults());
  QStringList stems;
  for (const NamedFigure& figure : all) {
    EXPECT_FALSE(stems.contains(figure.stem)) << figure.stem.toStdString();
    stems << figure.stem;
    const PlotSpec spec = figure.make();
    EXPECT_FALSE(spec.series.isEmpty()) << figure.stem.toStdString();
    EXPECT_FALSE(spec.x.title.isEmpty() || spec.y.title.isEmpty()) << figure.stem.toStdString();
    EXPECT_FALSE(figure.caption.isEmpty()) << figure.stem.toStdString();
  }
  for (const char* stem : {"sensor-over-encoder",
                           "error-over-encoder",
                           "error-over-sensor",
                           "sensor-unwrapped",
                           "projection",
                           "correction-curve",
                           "correction-curve-repeated",
                           "harmonic-amplitudes",
                           "harmonic-phases",
                           "models",
                           "residual",
                           "residual-at-points",
                           "growing-harmonics",
                           "linear-methods",
                           "growing-segments",
                           "table-steps",
                           "growing-entries",
                           "comparison-maximum",
                           "comparison-rms",
                           "verification-before-after",
                           "verification"}) {
    EXPECT_TRUE(stems.contains(stem)) << stem;
  }
  auto fileOnly = std::make_shared<AngleResults>();
  fileOnly->calibration = exampleRun().result;
  stems.clear();
  for (const NamedFigure& figure : angleFigures(fileOnly)) {
    stems << figure.stem;
  }
  EXPECT_EQ(stems, (QStringList{"harmonic-amplitudes", "harmonic-phases", "models"}));
}

} // namespace
} // namespace straightedge::gui
