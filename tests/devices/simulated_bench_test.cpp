// The simulated bench does what it says: truth, geometry, noise, hysteresis, quantisation, settling.
#include "devices/simulated/shaft_motion.h"
#include "devices/simulated/simulated_angle_bench.h"
#include "devices/simulated/simulated_settings_json.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace straightedge::devices {
namespace {

SimulatedAngleSettings ideal() {
  SimulatedAngleSettings settings;
  settings.realTime = false;
  settings.noiseDeg = 0.0;
  settings.hysteresisDeg = 0.0;
  settings.sensorBits = 0;
  settings.encoderStepDeg = 0.0;
  return settings;
}

double wrapped(double deg) { return std::remainder(deg, 360.0); }

double readAt(const AngleBench& bench, double shaftDeg) {
  EXPECT_TRUE(bench.stage->moveToDeg(shaftDeg));
  bench.clock->sleepS(0.3);
  return bench.sensor->readDeg()->value;
}

/// Amplitudes of the correction's harmonics 1, 2, …
std::vector<double> harmonics(const SimulatedAngleBench& bench, int count) {
  constexpr int n = 720;
  std::vector<double> amplitudes;
  for (int order = 1; order <= count; ++order) {
    std::complex<double> sum = 0.0;
    for (int i = 0; i < n; ++i) {
      sum += bench.trueCorrectionDeg(360.0 * i / n) * std::polar(1.0, -2.0 * std::numbers::pi * order * i / n);
    }
    amplitudes.push_back(2.0 * std::abs(sum) / n);
  }
  return amplitudes;
}

TEST(SimulatedBenchTest, CorrectionUndoesTheSensorToTheLastDigits) {
  for (const auto geometry : {FieldGeometry::OnAxis, FieldGeometry::SideShaft}) {
    for (const bool decreasing : {false, true}) {
      SimulatedAngleSettings settings = ideal();
      settings.geometry = geometry;
      settings.decreasing = decreasing;
      settings.mountingAngleDeg = 123.456;
      const SimulatedAngleBench bench(settings);
      for (int i = -1000; i < 2000; ++i) {
        const double shaft = 0.37 * i;
        const double sensor = bench.trueSensorDeg(shaft);
        ASSERT_GE(sensor, 0.0);
        ASSERT_LT(sensor, 360.0);
        const double reading = decreasing ? 360.0 - sensor : sensor;
        ASSERT_NEAR(wrapped(reading + bench.trueCorrectionDeg(reading) - shaft), 0.0, 1e-12 * 360.0);
        ASSERT_GE(bench.trueCorrectionDeg(reading), -180.0);
        ASSERT_LT(bench.trueCorrectionDeg(reading), 180.0);
      }
    }
  }
}

TEST(SimulatedBenchTest, SideShaftIsLikeThePublishedExampleAndOnAxisIsMild) {
  SimulatedAngleSettings settings = ideal();
  const auto side = harmonics(SimulatedAngleBench(settings), 4);
  EXPECT_NEAR(side[0], 8.15, 1.0);
  EXPECT_NEAR(side[1], 5.38, 1.0);
  EXPECT_NEAR(side[2], 1.08, 0.8);
  settings.geometry = FieldGeometry::OnAxis;
  const auto onAxis = harmonics(SimulatedAngleBench(settings), 4);
  EXPECT_GT(onAxis[0], 0.2);
  EXPECT_LT(onAxis[0], 1.0);
  EXPECT_LT(onAxis[1], 0.5);
}

TEST(SimulatedBenchTest, AnIdealBenchReadsTheTruth) {
  SimulatedAngleBench bench(ideal());
  for (const double shaft : {0.0, 17.25, 359.9, 725.0, -200.0}) {
    EXPECT_NEAR(wrapped(readAt(bench.bench(), shaft) - bench.trueSensorDeg(shaft)), 0.0, 1e-9);
    EXPECT_NEAR(bench.bench().reference->readDeg()->value, shaft, 1e-9);
  }
}

TEST(SimulatedBenchTest, MountingAngleIsWhereTheSensorReadsZero) {
  SimulatedAngleSettings settings = ideal();
  settings.ellipticity = 1e-9;
  settings.eccentricity = 1e-9;
  settings.mountingAngleDeg = 80.0;
  EXPECT_NEAR(wrapped(SimulatedAngleBench(settings).trueSensorDeg(80.0)), 0.0, 1e-6);
  EXPECT_NEAR(SimulatedAngleBench(settings).trueSensorDeg(90.0), 10.0, 1e-6);
  settings.decreasing = true;
  EXPECT_NEAR(SimulatedAngleBench(settings).trueSensorDeg(90.0), 350.0, 1e-6);
}

TEST(SimulatedBenchTest, HysteresisIsHalfTheLoop) {
  SimulatedAngleSettings settings = ideal();
  settings.hysteresisDeg = 0.4;
  SimulatedAngleBench bench(settings);
  std::ignore = readAt(bench.bench(), -10.0);
  const double rising = readAt(bench.bench(), 50.0);
  std::ignore = readAt(bench.bench(), 60.0);
  const double falling = readAt(bench.bench(), 50.0);
  EXPECT_NEAR(wrapped(falling - rising) / 2.0, 0.4, 1e-6);
  EXPECT_NEAR(wrapped((falling + rising) / 2.0 - bench.trueSensorDeg(50.0)), 0.0, 1e-6);
}

TEST(SimulatedBenchTest, NoiseHasItsStandardDeviationAndItsSeed) {
  SimulatedAngleSettings settings = ideal();
  settings.noiseDeg = 0.1;
  SimulatedAngleBench bench(settings);
  SimulatedAngleBench same(settings);
  settings.seed = 2;
  SimulatedAngleBench other(settings);
  double sum = 0.0;
  double squares = 0.0;
  int differing = 0;
  constexpr int count = 20000;
  for (int i = 0; i < count; ++i) {
    const double reading = bench.bench().sensor->readDeg()->value;
    EXPECT_EQ(reading, same.bench().sensor->readDeg()->value);
    differing += reading != other.bench().sensor->readDeg()->value ? 1 : 0;
    const double error = wrapped(reading - bench.trueSensorDeg(0.0));
    sum += error;
    squares += error * error;
  }
  EXPECT_GT(differing, count / 2);
  EXPECT_NEAR(sum / count, 0.0, 4.0 * 0.1 / std::sqrt(count));
  EXPECT_NEAR(std::sqrt(squares / count), 0.1, 0.002);
}

TEST(SimulatedBenchTest, SensorAndEncoderHaveSteps) {
  SimulatedAngleSettings settings = ideal();
  settings.sensorBits = 10;
  settings.encoderStepDeg = 0.25;
  SimulatedAngleBench bench(settings);
  for (double shaft = 0.0; shaft < 400.0; shaft += 7.77) {
    const double steps = readAt(bench.bench(), shaft) * 1024.0 / 360.0;
    EXPECT_NEAR(steps, std::round(steps), 1e-9);
    EXPECT_LT(steps, 1023.5) << "a step of 360° is 0°";
    EXPECT_NEAR(wrapped(steps * 360.0 / 1024.0 - bench.trueSensorDeg(shaft)), 0.0, 180.0 / 1024.0 + 1e-9);
    const double encoder = bench.bench().reference->readDeg()->value;
    EXPECT_EQ(encoder, 0.25 * std::round(encoder / 0.25));
  }
}

TEST(SimulatedBenchTest, TheShaftCreepsInAndNeverOvershoots) {
  ShaftMotion motion(360.0);
  motion.moveTo(90.0, 1.0);
  EXPECT_TRUE(motion.isMoving(1.2));
  EXPECT_FALSE(motion.isMoving(1.26));
  double before = 0.0;
  for (double time = 1.0; time < 1.5; time += 0.001) {
    const double position = motion.positionDeg(time);
    EXPECT_GE(position, before);
    EXPECT_LE(position, 90.0);
    before = position;
  }
  EXPECT_LT(motion.positionDeg(1.25), 89.0) << "the stage says it is there before the shaft is";
  EXPECT_NEAR(motion.positionDeg(1.30), 90.0, 1e-4) << "after the default settling time";
  motion.moveTo(0.0, 1.5);
  motion.halt(1.6);
  EXPECT_NEAR(motion.positionDeg(3.0), 90.0 - 36.0, 1e-9);
}

TEST(SimulatedBenchTest, StreamKeepsItsRateAndCountsWhatItLoses) {
  SimulatedAngleBench bench(ideal());
  AngleStream& stream = *bench.bench().stream;
  ASSERT_TRUE(stream.start({.rateHz = 1000.0}));
  bench.bench().clock->sleepS(0.1005);
  const auto block = stream.read();
  ASSERT_EQ(block->samples.size(), 101U);
  EXPECT_NEAR(block->samples[50].timeS - block->samples[0].timeS, 0.05, 1e-12);
  EXPECT_EQ(block->lost, 0);
  bench.bench().clock->sleepS(70.0);
  const auto late = stream.read();
  EXPECT_EQ(late->samples.size(), 65536U);
  EXPECT_EQ(static_cast<std::int64_t>(late->samples.size()) + late->lost, 70000);
}

TEST(SimulatedBenchTest, SettingsSurviveTheirJson) {
  SimulatedAngleSettings settings;
  settings.geometry = FieldGeometry::OnAxis;
  settings.ellipticity = 0.125;
  settings.decreasing = true;
  settings.noiseDeg = 0.1;
  settings.sensorBits = 12;
  settings.realTime = false;
  settings.seed = 18446744073709551615ULL;
  const auto read = simulatedSettingsFromJson(simulatedSettingsToJson(settings));
  ASSERT_TRUE(read);
  EXPECT_EQ(simulatedSettingsToJson(*read), simulatedSettingsToJson(settings));
  EXPECT_EQ(read->seed, settings.seed);
  EXPECT_FALSE(simulatedSettingsFromJson("{\"noise_deg\":\"loud\"}"));
  EXPECT_FALSE(simulatedSettingsFromJson(""));
}

} // namespace
} // namespace straightedge::devices
