#include "core/angle/alignment.h"
#include "tests/core/angle/synthetic_sweep.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

namespace straightedge::angle {
namespace {

AlignedSweep aligned(const Sweep& sweep) {
  auto result = alignSweep(sweep);
  EXPECT_TRUE(result.has_value()) << result.error().message();
  return result ? std::move(*result) : AlignedSweep{};
}

void shuffle(Sweep& sweep, std::uint64_t seed) {
  Randomness random(seed);
  for (std::size_t i = sweep.size(); i > 1; --i) {
    const std::size_t j = random.below(i);
    std::swap(sweep.encoderDeg[i - 1], sweep.encoderDeg[j]);
    std::swap(sweep.sensorDeg[i - 1], sweep.sensorDeg[j]);
  }
}

void expectSamePoints(const AlignedSweep& a, const AlignedSweep& b, double tolerance) {
  ASSERT_EQ(a.readingDeg.size(), b.readingDeg.size());
  EXPECT_LE((a.readingDeg - b.readingDeg).cwiseAbs().maxCoeff(), tolerance);
  EXPECT_LE((a.correctionDeg - b.correctionDeg).cwiseAbs().maxCoeff(), tolerance);
  EXPECT_LE((a.encoderDeg - b.encoderDeg).cwiseAbs().maxCoeff(), tolerance);
}

bool hasWarning(const AlignedSweep& sweep, Warning::Topic topic) {
  return std::any_of(sweep.warnings.begin(), sweep.warnings.end(),
                     [&](const Warning& warning) { return warning.topic == topic; });
}

std::string warningText(const AlignedSweep& sweep, Warning::Topic topic) {
  for (const Warning& warning : sweep.warnings) {
    if (warning.topic == topic) {
      return warning.text;
    }
  }
  return "";
}

TEST(Alignment, SortsByReadingAndGivesEncoderMinusReading) {
  const SyntheticSensor sensor;
  const AlignedSweep points = aligned(sweepOf(sensor, 36));
  ASSERT_EQ(points.readingDeg.size(), 36);
  EXPECT_TRUE(std::is_sorted(points.readingDeg.begin(), points.readingDeg.end()));
  EXPECT_EQ(points.direction, SensorDirection::Increasing);
  EXPECT_EQ(points.distinctAngles, 36U);
  EXPECT_FALSE(points.repeats);
  EXPECT_TRUE(points.gaps.empty());
  EXPECT_TRUE(points.warnings.empty());
  for (Eigen::Index i = 0; i < 36; ++i) {
    EXPECT_NEAR(wrap180(points.correctionDeg(i) - sensor.correctionDeg(points.readingDeg(i))), 0.0, 1e-9);
    EXPECT_EQ(points.encoderDeg(i), 10.0 * static_cast<double>(points.row[static_cast<std::size_t>(i)]));
  }
}

TEST(Alignment, CorrectionIsContinuousWhereverTheOffsetLies) {
  for (double offset = -360.0; offset <= 360.0; offset += 7.5) {
    SyntheticSensor sensor;
    sensor.offsetDeg = offset;
    const AlignedSweep points = aligned(sweepOf(sensor, 36));
    EXPECT_GE(points.correctionDeg.mean(), -180.0);
    EXPECT_LT(points.correctionDeg.mean(), 180.0);
    for (Eigen::Index i = 0; i < 36; ++i) {
      EXPECT_LT(std::abs(points.correctionDeg(i) - points.correctionDeg((i + 1) % 36)), 10.0) << offset;
    }
  }
}

TEST(Alignment, OrderStartAndTurnOfTheRowsDoNotMatter) {
  const SyntheticSensor sensor;
  const Sweep plain = sweepOf(sensor, 36);
  const AlignedSweep expected = aligned(plain);

  Sweep shuffled = plain;
  shuffle(shuffled, 3);
  expectSamePoints(aligned(shuffled), expected, 0.0);

  Sweep backwards = plain;
  std::reverse(backwards.encoderDeg.begin(), backwards.encoderDeg.end());
  std::reverse(backwards.sensorDeg.begin(), backwards.sensorDeg.end());
  const AlignedSweep falling = aligned(backwards);
  expectSamePoints(falling, expected, 0.0);
  EXPECT_THAT(falling.pass, testing::Each(-1));
  EXPECT_THAT(expected.pass, testing::Each(1));

  for (const double start : {130.0, -250.0, 720.0}) {
    expectSamePoints(aligned(sweepOf(sensor, 36, start)), expected, 1e-9);
  }
}

TEST(Alignment, SensorOf360ReadsAsZero) {
  SyntheticSensor sensor;
  sensor.offsetDeg = 0.0;
  sensor.terms.clear();
  Sweep sweep = sweepOf(sensor, 36);
  ASSERT_EQ(sweep.sensorDeg[0], 0.0);
  const AlignedSweep expected = aligned(sweep);
  sweep.sensorDeg[0] = 360.0;
  expectSamePoints(aligned(sweep), expected, 0.0);
}

TEST(Alignment, SensorThatRunsBackwardsIsMirroredAndNoted) {
  SyntheticSensor sensor;
  const AlignedSweep forwards = aligned(sweepOf(sensor, 36));
  sensor.decreasing = true;
  const AlignedSweep mirrored = aligned(sweepOf(sensor, 36));
  EXPECT_EQ(mirrored.direction, SensorDirection::Decreasing);
  expectSamePoints(mirrored, forwards, 1e-9);
  EXPECT_EQ(warningText(mirrored, Warning::Topic::SensorRunsBackwards),
            "The sensor's angle falls while the encoder's rises: it is corrected as 360° minus the reading.");
  EXPECT_FALSE(hasWarning(forwards, Warning::Topic::SensorRunsBackwards));
}

TEST(Alignment, NoisyDenseReadingsStayOnTheirTurn) {
  const SyntheticSensor sensor;
  Sweep sweep = sweepOf(sensor, 5000);
  Randomness random(11);
  for (double& reading : sweep.sensorDeg) { // steps of 0.07° in noise of 2°, rounded to 0.5°
    reading = wrap360(0.5 * std::round(2.0 * (reading + 2.0 * random.normal())));
  }
  const AlignedSweep points = aligned(sweep);
  EXPECT_TRUE(points.repeats);
  for (Eigen::Index i = 0; i < points.readingDeg.size(); ++i) {
    EXPECT_LT(std::abs(wrap180(points.correctionDeg(i) - sensor.correctionDeg(points.readingDeg(i)))), 16.0);
    EXPECT_LT(std::abs(points.correctionDeg(i) - points.correctionDeg.mean()), 30.0);
  }
}

TEST(Alignment, StepsBackAreRepeatsThoughNoReadingOccursTwice) {
  Sweep sweep = sweepOf({}, 36);
  EXPECT_FALSE(aligned(sweep).repeats);
  sweep.sensorDeg[20] = wrap360(sweep.sensorDeg[20] - 12.0); // below its predecessor
  EXPECT_TRUE(aligned(sweep).repeats);
}

TEST(Alignment, FewAnglesAreWarnedAbout) {
  SyntheticSensor calm;
  calm.terms = {{1, 1.0, 0.0}};
  const AlignedSweep fifteen = aligned(sweepOf(calm, 15));
  EXPECT_EQ(warningText(fifteen, Warning::Topic::FewAngles), "Only 15 distinct angles: at least 16 are recommended.");
  EXPECT_FALSE(hasWarning(fifteen, Warning::Topic::FewAnglesForSwing));
  EXPECT_TRUE(aligned(sweepOf(calm, 16)).warnings.empty());

  SyntheticSensor wide;
  wide.terms = {{1, 4.0, 0.0}};
  EXPECT_EQ(warningText(aligned(sweepOf(wide, 20)), Warning::Topic::FewAnglesForSwing),
            "The correction swings by 8.00°, but there are only 20 distinct angles: above 5° at least 32 are "
            "recommended.");
  EXPECT_TRUE(aligned(sweepOf(wide, 32)).warnings.empty());
}

TEST(Alignment, GapsAreFoundAndNamed) {
  SyntheticSensor straight;
  straight.offsetDeg = 5.0;
  straight.terms = {{1, 0.1, 0.0}};
  Sweep sweep = sweepOf(straight, 72);
  sweep.enabled.assign(72, true);
  EXPECT_TRUE(aligned(sweep).gaps.empty());
  for (const std::size_t row : {10U, 11U, 30U, 31U, 32U}) {
    sweep.enabled[row] = false;
  }
  const AlignedSweep points = aligned(sweep);
  ASSERT_EQ(points.gaps.size(), 2U);
  EXPECT_NEAR(points.gaps[0].fromDeg, 50.0, 0.2);
  EXPECT_NEAR(points.gaps[0].widthDeg, 15.0, 0.1);
  EXPECT_NEAR(points.gaps[1].fromDeg, 150.0, 0.2);
  EXPECT_NEAR(points.gaps[1].widthDeg, 20.0, 0.1);
  EXPECT_NEAR(points.medianGapDeg, 5.0, 0.1);
  EXPECT_NEAR(points.largestGapDeg, 20.0, 0.1);
  EXPECT_EQ(warningText(points, Warning::Topic::CoverageGap),
            "2 gaps in the sensor angles, the widest 20.0° from 149.9° to 169.9°: more than twice the median distance "
            "of 5.00°; the correction is uncertain there.");

  SyntheticSensor mirrored = straight;
  mirrored.decreasing = true;
  Sweep falling = sweepOf(mirrored, 72);
  falling.enabled = sweep.enabled;
  const AlignedSweep back = aligned(falling);
  ASSERT_EQ(back.gaps.size(), 2U);
  EXPECT_NEAR(back.gaps[1].fromDeg, 360.0 - 170.0, 0.2) << "named in the sensor's own angle";
}

TEST(Alignment, DenseRandomAnglesAreNotFullOfGaps) {
  Sweep sweep;
  Randomness random(2);
  for (int i = 0; i < 3000; ++i) {
    sweep.encoderDeg.push_back(360.0 * random.uniform());
    sweep.sensorDeg.push_back(SyntheticSensor{}.sensorDeg(sweep.encoderDeg.back()));
  }
  EXPECT_LE(aligned(sweep).gaps.size(), 3U);
}

TEST(Alignment, HundredThousandRowsInAnyOrder) {
  Sweep sweep = sweepOf({}, 100000);
  shuffle(sweep, 1);
  const AlignedSweep points = aligned(sweep);
  EXPECT_EQ(points.distinctAngles, 100000U);
  EXPECT_FALSE(points.repeats);
}

} // namespace
} // namespace straightedge::angle
