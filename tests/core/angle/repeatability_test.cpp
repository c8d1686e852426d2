#include "core/angle/alignment.h"
#include "tests/core/angle/synthetic_sweep.h"

#include <gtest/gtest.h>

namespace straightedge::angle {
namespace {

/// `turns` turns up and `turns` down, stopping at 36 angles for `readings` readings each.
struct Plan {
  int turns = 2;
  bool bothDirections = true;
  int readings = 5;
  double noiseDeg = 0.0;
  double perTurnDeg = 0.0;    ///< standard deviation of an offset of each angle, direction and turn
  double hysteresisDeg = 0.0; ///< rising readings lag behind, falling ones lead
  bool recorded = false;      ///< fill the columns turn and direction
  double startDeg = 0.0;
};

Sweep capture(const Plan& plan, std::uint64_t seed = 1) {
  const SyntheticSensor sensor;
  Randomness random(seed);
  Sweep sweep;
  sweep.source.file = "sweep.csv";
  const int steps = 36 * plan.turns;
  for (int direction = 1; direction >= (plan.bothDirections ? -1 : 1); direction -= 2) {
    for (int step = 0; step < steps; ++step) {
      const int position = direction > 0 ? step : steps - 1 - step;
      const double encoder = plan.startDeg + 10.0 * position;
      const double shift = plan.perTurnDeg * random.normal() - direction * plan.hysteresisDeg;
      for (int reading = 0; reading < plan.readings; ++reading) {
        sweep.encoderDeg.push_back(encoder);
        sweep.sensorDeg.push_back(wrap360(sensor.sensorDeg(encoder) + shift + plan.noiseDeg * random.normal()));
        if (plan.recorded) {
          sweep.turn.push_back(position / 36);
          sweep.direction.push_back(direction);
        }
      }
    }
  }
  return sweep;
}

Repeatability passesOf(const Sweep& sweep) {
  const auto aligned = alignSweep(sweep);
  EXPECT_TRUE(aligned.has_value()) << aligned.error().message();
  return aligned ? aligned->passes : Repeatability{};
}

TEST(Repeatability, OnePassTellsNothing) {
  const Repeatability passes = passesOf(sweepOf({}, 36));
  EXPECT_EQ(passes.turns, 1);
  EXPECT_FALSE(passes.bothDirections);
  EXPECT_FALSE(passes.noiseDeg.has_value());
  EXPECT_FALSE(passes.repeatabilityDeg.has_value());
  EXPECT_FALSE(passes.hysteresisMaxDeg.has_value());
}

TEST(Repeatability, TurnsAndDirectionsAreRecoveredFromTheRows) {
  for (const double start : {0.0, 137.0, -500.0}) {
    const Repeatability both = passesOf(capture({.turns = 3, .readings = 2, .startDeg = start}));
    EXPECT_EQ(both.turns, 3);
    EXPECT_TRUE(both.bothDirections);
    const Repeatability up = passesOf(capture({.turns = 3, .bothDirections = false, .readings = 1, .startDeg = start}));
    EXPECT_EQ(up.turns, 3);
    EXPECT_FALSE(up.bothDirections);
  }
  // The same when the encoder starts again at 0 with every turn.
  Sweep wrapped = capture({.turns = 3, .readings = 2});
  for (double& encoder : wrapped.encoderDeg) {
    encoder = wrap360(encoder);
  }
  EXPECT_EQ(passesOf(wrapped).turns, 3);
  EXPECT_TRUE(passesOf(wrapped).bothDirections);
}

TEST(Repeatability, TurnThatEndsWhereItBeganIsOneTurn) {
  Sweep sweep = sweepOf({}, 36);
  sweep.encoderDeg.push_back(360.0);
  sweep.sensorDeg.push_back(sweep.sensorDeg.front());
  EXPECT_EQ(passesOf(sweep).turns, 1);
}

TEST(Repeatability, HysteresisIsHalfTheDifferenceOfTheDirections) {
  const Repeatability passes = passesOf(capture({.hysteresisDeg = 0.25}));
  ASSERT_EQ(passes.hysteresisDeg.size(), 36U);
  EXPECT_NEAR(passes.hysteresisMaxDeg.value_or(0.0), 0.25, 1e-9);
  EXPECT_NEAR(passes.hysteresisRmsDeg.value_or(0.0), 0.25, 1e-9);
  EXPECT_NEAR(passes.noiseDeg.value_or(1.0), 0.0, 1e-9);
  EXPECT_NEAR(passes.repeatabilityDeg.value_or(1.0), 0.0, 1e-9);
  const SyntheticSensor sensor;
  for (std::size_t i = 0; i < 36; ++i) {
    EXPECT_NEAR(passes.encoderDeg[i], 10.0 * static_cast<double>(i), 1e-9);
    EXPECT_NEAR(passes.hysteresisDeg[i], -0.25, 1e-9);
    EXPECT_NEAR(wrap180(passes.risingMeanDeg[i] - (sensor.errorDeg(passes.encoderDeg[i]) - 0.25)), 0.0, 1e-9);
    EXPECT_NEAR(wrap180(passes.fallingMeanDeg[i] - (sensor.errorDeg(passes.encoderDeg[i]) + 0.25)), 0.0, 1e-9);
  }
}

TEST(Repeatability, NoiseRepeatabilityAndHysteresisAreKeptApart) {
  // Three standard deviations of the estimates: 1152 and 216 degrees of freedom.
  for (const bool recorded : {false, true}) {
    const Repeatability passes = passesOf(capture(
        {.turns = 4, .noiseDeg = 0.1, .perTurnDeg = 0.06, .hysteresisDeg = 0.25, .recorded = recorded, .startDeg = 3}));
    EXPECT_NEAR(passes.noiseDeg.value_or(0.0), 0.1, 0.006);
    EXPECT_NEAR(passes.repeatabilityDeg.value_or(0.0), 0.06, 0.0135);
    EXPECT_NEAR(passes.hysteresisRmsDeg.value_or(0.0), 0.25, 0.01);
  }
}

TEST(Repeatability, NoiseAloneIsNotTakenForRepeatability) {
  const Repeatability passes = passesOf(capture({.turns = 4, .noiseDeg = 0.1}));
  EXPECT_NEAR(passes.noiseDeg.value_or(0.0), 0.1, 0.006);
  EXPECT_LT(passes.repeatabilityDeg.value_or(1.0), 0.02) << "plain scatter of the means would be 0.045";
}

TEST(Repeatability, StageThatReturnsOnlyNearlyStillRepeats) {
  Sweep sweep = capture({.turns = 2, .noiseDeg = 0.02, .hysteresisDeg = 0.25});
  Randomness random(4);
  const SyntheticSensor sensor;
  for (std::size_t i = 0; i < sweep.size(); ++i) {
    const double miss = 0.002 * random.normal();
    sweep.sensorDeg[i] = wrap360(sweep.sensorDeg[i] + miss);
    sweep.encoderDeg[i] += miss;
  }
  const auto aligned = alignSweep(sweep);
  ASSERT_TRUE(aligned.has_value());
  EXPECT_EQ(aligned->distinctAngles, 36U);
  EXPECT_NEAR(aligned->passes.hysteresisRmsDeg.value_or(0.0), 0.25, 0.01);
  EXPECT_NEAR(aligned->passes.noiseDeg.value_or(0.0), 0.02, 0.002);
}

TEST(Repeatability, SensorThatRunsBackwardsGivesTheSameFigures) {
  Sweep sweep = capture({.turns = 2, .noiseDeg = 0.05, .hysteresisDeg = 0.25});
  const Repeatability forwards = passesOf(sweep);
  for (double& sensor : sweep.sensorDeg) {
    sensor = wrap360(360.0 - sensor);
  }
  const Repeatability backwards = passesOf(sweep);
  EXPECT_NEAR(backwards.noiseDeg.value_or(0.0), forwards.noiseDeg.value_or(1.0), 1e-9);
  EXPECT_NEAR(backwards.hysteresisMaxDeg.value_or(0.0), forwards.hysteresisMaxDeg.value_or(1.0), 1e-9);
}

} // namespace
} // namespace straightedge::angle
