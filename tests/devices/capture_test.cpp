// Capture on the simulated bench: what was planned is what the sink gets.
#include "devices/capture/angle_capture.h"
#include "devices/simulated/simulated_angle_bench.h"
#include "tests/devices/memory_sink.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace straightedge::devices {
namespace {

using testing::HasSubstr;

SimulatedAngleSettings virtualBench() {
  SimulatedAngleSettings settings;
  settings.realTime = false;
  return settings;
}

TEST(AngleCaptureTest, MeasuresEveryPlannedPointInOrder) {
  SimulatedAngleBench bench(virtualBench());
  tests::MemorySink sink;
  AngleCapture capture(bench.bench(), sink);
  const AnglePlan plan{.pointsPerTurn = 16, .turns = 2, .bothDirections = true, .startDeg = 5.0, .averages = 3};
  ASSERT_TRUE(capture.start(plan));
  capture.waitUntilDone();

  const CaptureProgress progress = capture.progress();
  EXPECT_EQ(progress.state, CaptureState::Finished);
  EXPECT_EQ(progress.pointsDone, 64);
  EXPECT_EQ(progress.pointsPlanned, 64);
  EXPECT_EQ(progress.samples, 192);
  EXPECT_EQ(progress.samplesLost, 0);

  const auto points = plannedPoints(plan);
  const auto samples = sink.committed();
  ASSERT_EQ(samples.size(), 192U);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const PlannedPoint& point = points[i / 3];
    EXPECT_EQ(samples[i].sequence, static_cast<std::int64_t>(i));
    EXPECT_EQ(samples[i].point, point.index);
    EXPECT_EQ(samples[i].turn, point.turn);
    EXPECT_EQ(samples[i].direction, point.direction);
    EXPECT_EQ(samples[i].attempt, 0);
    EXPECT_NEAR(samples[i].encoderDeg, point.encoderDeg, 1e-4);
    EXPECT_TRUE(samples[i].temperatureC.has_value());
    const double away = std::remainder(samples[i].sensorDeg - bench.trueSensorDeg(samples[i].encoderDeg), 360.0);
    EXPECT_LT(std::abs(away), 0.05 + 5 * 0.02 + 0.011) << i;
    if (i > 0) {
      EXPECT_GT(samples[i].timeS, samples[i - 1].timeS);
    }
  }
  EXPECT_EQ(capture.takeNewSamples().size(), 192U);
  EXPECT_TRUE(capture.takeNewSamples().empty());
}

TEST(AngleCaptureTest, ComesToEveryPointFromItsDirectionAlsoAtTheStartAndTheReversal) {
  SimulatedAngleSettings settings = virtualBench();
  settings.noiseDeg = 0.0;
  settings.sensorBits = 0;
  settings.hysteresisDeg = 0.5;
  SimulatedAngleBench bench(settings);
  tests::MemorySink sink;
  AngleCapture capture(bench.bench(), sink);
  ASSERT_TRUE(capture.start({.pointsPerTurn = 16, .bothDirections = true}));
  capture.waitUntilDone();
  for (const auto& sample : sink.committed()) {
    const double away = std::remainder(sample.sensorDeg - bench.trueSensorDeg(sample.encoderDeg), 360.0);
    EXPECT_NEAR(away, -0.5 * sample.direction, 1e-3) << "point " << sample.point;
  }
}

TEST(AngleCaptureTest, FreeRunningPassesEverySectorAtTheRate) {
  SimulatedAngleBench bench(virtualBench());
  tests::MemorySink sink;
  AngleCapture capture(bench.bench(), sink);
  const AnglePlan plan{.pointsPerTurn = 36, .turns = 1, .bothDirections = true, .sampleRateHz = 10000.0};
  ASSERT_TRUE(capture.start(plan));
  capture.waitUntilDone();
  ASSERT_EQ(capture.progress().state, CaptureState::Finished) << capture.progress().error->message();
  EXPECT_EQ(capture.progress().pointsDone, 72);
  const auto samples = sink.committed();
  // 360° at 360°/s, twice
  EXPECT_NEAR(static_cast<double>(samples.size()), 20000.0, 20.0);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    ASSERT_EQ(samples[i].sequence, static_cast<std::int64_t>(i));
    if (i > 0) {
      ASSERT_GE(samples[i].point, samples[i - 1].point);
      ASSERT_LE(samples[i].point, samples[i - 1].point + 1);
    }
  }
  EXPECT_TRUE(sink.gaps().empty());
}

TEST(AngleCaptureTest, RefusesAnImpossiblePlan) {
  SimulatedAngleBench bench(virtualBench());
  tests::MemorySink sink;
  AngleCapture capture(bench.bench(), sink);
  const auto started = capture.start({.pointsPerTurn = 7});
  ASSERT_FALSE(started);
  EXPECT_EQ(started.error().kind, ErrorKind::Usage);
  EXPECT_EQ(started.error().message(), "capture plan: the number of points per turn is 7; give 8 to 36000");
}

} // namespace
} // namespace straightedge::devices
