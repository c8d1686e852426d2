#include "app/gui/figures/sweep_figures.h"
#include "tests/app/gui/figures/example_results.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace straightedge::gui {
namespace {

using testing::exampleRun;
using testing::exampleSweep;

angle::Sweep bothWays() {
  angle::Sweep sweep;
  for (const int direction : {1, -1}) {
    for (int i = 0; i < 12; ++i) {
      const double encoder = i * 30.0;
      sweep.encoderDeg.push_back(encoder);
      sweep.sensorDeg.push_back(std::fmod(encoder + 10.0 + 0.1 * direction, 360.0));
      sweep.direction.push_back(direction);
    }
  }
  return sweep;
}

TEST(SensorOverEncoder, HasARowPerPointAndBreaksItsLineAtTheWrap) {
  const angle::Sweep sweep = exampleSweep();
  const RowFigure figure = sensorOverEncoderFigure(sweep);
  ASSERT_EQ(figure.spec.series.size(), 2);
  ASSERT_EQ(figure.rows.size(), 2U);
  const PlotSeries& points = figure.spec.series[0];
  ASSERT_EQ(points.x.size(), 32);
  for (int i = 0; i < 32; ++i) {
    const std::size_t row = figure.rows[0][static_cast<std::size_t>(i)];
    EXPECT_EQ(points.x[i], sweep.encoderDeg[row]);
    EXPECT_EQ(points.y[i], sweep.sensorDeg[row]);
  }
  EXPECT_TRUE(figure.rows[1].empty());
  EXPECT_EQ(std::ranges::count_if(figure.spec.series[1].y, [](double y) { return std::isnan(y); }), 1);
  EXPECT_EQ(figure.spec.x.title, "Encoder angle (°)");
  EXPECT_EQ(figure.spec.y.title, "Sensor angle (°)");
  EXPECT_EQ(figure.spec.note, "32 readings");
}

TEST(SensorOverEncoder, MarksSwitchedOffRowsAndLeavesThemOutOfTheLine) {
  angle::Sweep sweep = exampleSweep();
  sweep.enabled.assign(sweep.size(), true);
  sweep.enabled[5] = false;
  const RowFigure figure = sensorOverEncoderFigure(sweep);
  EXPECT_EQ(figure.spec.series[0].emphasised.count(true), 1);
  EXPECT_TRUE(figure.spec.series[0].emphasised[5]);
  EXPECT_FALSE(figure.spec.series[1].x.contains(sweep.encoderDeg[5]));
  EXPECT_EQ(figure.spec.note, "32 readings, 1 switched off");
}

TEST(SensorOverEncoder, KeepsDirectionsApart) {
  const RowFigure figure = sensorOverEncoderFigure(bothWays());
  ASSERT_EQ(figure.spec.series.size(), 2);
  EXPECT_EQ(figure.spec.series[0].name, "Rising");
  EXPECT_EQ(figure.spec.series[1].name, "Falling");
  EXPECT_EQ(figure.rows[1].front(), 12U);
}

TEST(SensorOverEncoder, SaysWhatToDoWithoutReadings) {
  const PlotSpec spec = liveSensorFigure();
  ASSERT_EQ(spec.series.size(), 1);
  EXPECT_TRUE(spec.series[0].x.isEmpty());
  EXPECT_TRUE(spec.note.contains("capture"));
}

TEST(Unwrapped, IsContinuousOverOneTurnAsPrintedInTheMethod) {
  const RowFigure figure = unwrappedFigure(exampleRun().aligned);
  std::vector<std::pair<double, double>> points;
  for (int i = 0; i < figure.spec.series[0].x.size(); ++i) {
    points.emplace_back(figure.spec.series[0].x[i], figure.spec.series[0].y[i]);
  }
  std::ranges::sort(points);
  ASSERT_EQ(points.size(), 32U);
  EXPECT_NEAR(points.front().second, -93.69, 1e-9); // 266.31° − 360°
  EXPECT_NEAR(points.back().second, 254.36, 1e-9);
  for (std::size_t i = 1; i < points.size(); ++i) {
    EXPECT_LT(points[i - 1].second, points[i].second);
  }
}

TEST(ErrorFigure, StaysContinuousAndNamesTheLargestError) {
  const RowFigure kept =
      errorFigure(exampleSweep(), angle::SensorDirection::Increasing, ErrorAxis::Encoder, ConstantPart::Kept);
  const QList<double>& y = kept.spec.series[0].y;
  EXPECT_NEAR(y[0], -93.69, 1e-9);
  EXPECT_NEAR(y[19], 137.46 - 213.75, 1e-9);
  EXPECT_TRUE(kept.spec.note.startsWith(QStringLiteral("Largest error −98"))) << kept.spec.note.toStdString();
  const RowFigure removed =
      errorFigure(exampleSweep(), angle::SensorDirection::Increasing, ErrorAxis::Sensor, ConstantPart::Removed);
  EXPECT_EQ(removed.spec.series[0].x[0], 266.31);
  const QList<double>& shape = removed.spec.series[0].y;
  EXPECT_NEAR(std::accumulate(shape.begin(), shape.end(), 0.0) / 32.0, 0.0, 0.2);
  EXPECT_NEAR(shape[0] - shape[19], y[0] - y[19], 1e-9);
}

TEST(ErrorFigure, TurnsADecreasingSensorRound) {
  angle::Sweep sweep = exampleSweep();
  for (double& value : sweep.sensorDeg) {
    value = 360.0 - value;
  }
  const RowFigure figure =
      errorFigure(sweep, angle::SensorDirection::Decreasing, ErrorAxis::Encoder, ConstantPart::Kept);
  EXPECT_NEAR(figure.spec.series[0].y[0], -93.69, 1e-9);
}

TEST(Hysteresis, ShowsBothDirectionsAboutTheirMean) {
  const auto run = testing::valueOf(angle::calibrate(bothWays(), {}, {}));
  const PlotSpec spec = hysteresisFigure(run.aligned.passes);
  ASSERT_EQ(spec.series.size(), 2);
  ASSERT_EQ(spec.series[0].y.size(), 12);
  EXPECT_NEAR(spec.series[0].y[3], 0.1, 1e-9);
  EXPECT_NEAR(spec.series[1].y[3], -0.1, 1e-9);
  const PlotSpec none = hysteresisFigure({});
  EXPECT_TRUE(none.series.isEmpty());
  EXPECT_TRUE(none.note.contains("both directions"));
}

TEST(CoverageRing, DrawsPlannedDoneAndGapsOnOneCircle) {
  const PlotSpec spec = coverageRingFigure({0.0, 90.0, 450.0}, {0.0}, {{350.0, 20.0}});
  ASSERT_TRUE(spec.polar);
  ASSERT_EQ(spec.series.size(), 3);
  EXPECT_EQ(spec.series[0].x, (QList<double>{0.0, 90.0, 90.0}));
  EXPECT_EQ(spec.series[1].x.size(), 1);
  const PlotSeries& arc = spec.series[2];
  EXPECT_EQ(arc.name, "Gap");
  EXPECT_EQ(arc.x.front(), 350.0);
  EXPECT_TRUE(arc.x.contains(0.0)); // goes on through the seam
  EXPECT_TRUE(std::isnan(arc.y.back()));
}

TEST(NoiseHistogram, CountsDeviationsWithinGroups) {
  angle::AlignedSweep aligned;
  const int groups = 20;
  aligned.readingDeg.resize(groups * 3);
  aligned.encoderDeg.resize(groups * 3);
  aligned.correctionDeg.resize(groups * 3);
  for (int g = 0; g < groups; ++g) {
    for (int i = 0; i < 3; ++i) {
      aligned.encoderDeg[g * 3 + i] = g * 18.0;
      aligned.readingDeg[g * 3 + i] = g * 18.0 + 0.01 * (i - 1);
      aligned.correctionDeg[g * 3 + i] = 5.0 - 0.01 * (i - 1);
    }
  }
  const PlotSpec spec = noiseHistogramFigure(aligned);
  ASSERT_EQ(spec.series.size(), 1);
  EXPECT_EQ(spec.series[0].style, SeriesStyle::Bars);
  EXPECT_EQ(std::accumulate(spec.series[0].y.begin(), spec.series[0].y.end(), 0.0), 60.0);
  EXPECT_EQ(spec.series[0].y.front(), 20.0); // a third reads 0.01° low, a third high, a third in the middle
  EXPECT_EQ(spec.series[0].y.back(), 20.0);
  EXPECT_TRUE(spec.note.startsWith("60 readings about the mean")) << spec.note.toStdString();
}

TEST(NoiseHistogram, SaysWhyThereIsNone) {
  EXPECT_TRUE(noiseHistogramFigure(exampleRun().aligned).note.contains("read once"));
}

} // namespace
} // namespace straightedge::gui
