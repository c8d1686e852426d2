#include "core/angle/calibration.h"
#include "core/angle/sweep_csv.h"
#include "tests/core/angle/synthetic_sweep.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <string>
#include <utility>

namespace straightedge::angle {
namespace {

const std::string dataFolder = STRAIGHTEDGE_TEST_DATA "/angle/";

CalibrationRun sideShaftRun(const CalibrationOptions& options = {}) {
  const auto sweep = readSweepCsv(dataFolder + "side_shaft_32.csv");
  auto run = calibrate(sweep.value(), options, {});
  EXPECT_TRUE(run.has_value()) << run.error().message();
  return std::move(run.value());
}

TEST(Calibration, DefaultModelsOfTheSideShaftSweep) {
  const CalibrationRun run = sideShaftRun();
  ASSERT_EQ(run.result.models.size(), 3U);
  ASSERT_EQ(run.result.uncertainty.size(), 3U);
  const auto expected = nlohmann::json::parse(std::ifstream(dataFolder + "side_shaft_32_expected.json"))["errors"];
  for (const Model& model : run.result.models) {
    const auto& errors = expected[model.name.text()];
    EXPECT_NEAR(model.errors.maxCurveDeg, errors["max_curve_deg"].get<double>(), 1e-6);
    EXPECT_NEAR(model.errors.maxPointsDeg, errors["max_points_deg"].get<double>(), 1e-6);
    EXPECT_NEAR(model.errors.rmsCurveDeg, errors["rms_curve_deg"].get<double>(), 1e-6);
    EXPECT_NEAR(model.errors.rmsPointsDeg, errors["rms_points_deg"].get<double>(), 1e-6);
  }
}

CalibrationRun runOf(const Sweep& sweep, const std::string& model = "harmonic:4") {
  CalibrationOptions options;
  options.models = {parseModelName(model).value()};
  auto run = calibrate(sweep, options, {});
  EXPECT_TRUE(run.has_value()) << run.error().message();
  return std::move(run.value());
}

std::string warningText(const CalibrationRun& run, Warning::Topic topic) {
  const auto found = std::find_if(run.result.warnings.begin(), run.result.warnings.end(),
                                  [&](const Warning& warning) { return warning.topic == topic; });
  return found == run.result.warnings.end() ? "" : found->text;
}

TEST(Calibration, ModelMoreAccurateThanTheDataIsSaid) {
  const CalibrationRun run = sideShaftRun();
  EXPECT_EQ(std::count_if(run.result.warnings.begin(), run.result.warnings.end(),
                          [](const Warning& w) { return w.topic == Warning::Topic::NoisyForModel; }),
            1);
  EXPECT_EQ(warningText(run, Warning::Topic::NoisyForModel),
            "linear:32 follows the correction curve to within 0.174°, but the points foretell one another only to "
            "0.213° (rms, leave-one-out): the model is more accurate than the data, which support no claim below about "
            "0.2°.");
}

TEST(Calibration, FewerPointsThanSegmentsAreSaid) {
  EXPECT_EQ(warningText(runOf(sweepOf({}, 36), "linear:37"), Warning::Topic::FewerPointsThanSegments),
            "linear:37 has more segments than there are distinct angles, 36: record at least as many angles as "
            "segments, better twice as many.");
  EXPECT_EQ(warningText(runOf(sweepOf({}, 36), "linear:36"), Warning::Topic::FewerPointsThanSegments), "");
}

TEST(Calibration, MoreHarmonicsThanTheRegressionFoundAreSaid) {
  CalibrationOptions options;
  options.models = {parseModelName("harmonic:7").value()};
  options.curve.method = CurveMethod::Regress;
  const CalibrationRun run = sideShaftRun(options);
  EXPECT_EQ(warningText(run, Warning::Topic::BeyondData),
            "harmonic:7 asks for more harmonics than the 6 that cross-validation found in the data: the others are 0.");
}

TEST(Calibration, ErrorsNameTheFile) {
  CalibrationOptions options;
  options.models = {parseModelName("harmonic:19").value()};
  const auto run = calibrate(sweepOf({}, 36), options, {});
  ASSERT_FALSE(run.has_value());
  EXPECT_EQ(run.error().kind, ErrorKind::Input);
  EXPECT_EQ(run.error().where, "sweep.csv");
}

TEST(Calibration, CarriesWhereItCameFrom) {
  Sweep sweep = sweepOf({}, 36);
  sweep.enabled.assign(36, true);
  sweep.enabled[4] = false;
  Traceability who;
  who.deviceSerial = "SN 7";
  const auto run = calibrate(sweep, {}, who);
  ASSERT_TRUE(run.has_value());
  EXPECT_EQ(run->result.source.file, "sweep.csv");
  EXPECT_EQ(run->result.source.points, 35);
  EXPECT_EQ(run->result.traceability.deviceSerial, "SN 7");
  EXPECT_EQ(run->result.software, "straightedge " STRAIGHTEDGE_VERSION);
  EXPECT_EQ(run->result.created, "");
}

// A sensor mounted at another angle is the same sensor: nothing but the offset may change.
TEST(Calibration, ErrorsDoNotDependOnTheSensorsZero) {
  Randomness random(9);
  Sweep noisy;
  const SyntheticSensor sensor;
  for (int i = 0; i < 240; ++i) {
    noisy.encoderDeg.push_back(1.8 * i); // a turn and a fifth: some angles twice
    noisy.sensorDeg.push_back(wrap360(sensor.sensorDeg(1.8 * i) + 0.2 * random.normal()));
  }
  for (const Sweep& sweep : {sweepOf(sensor, 48), noisy}) {
    const ModelErrors expected = runOf(sweep).result.models.front().errors;
    for (const double shift : {75.0, 104.9, 180.0, 260.0, 359.5}) {
      Sweep moved = sweep;
      for (double& reading : moved.sensorDeg) {
        reading = wrap360(reading + shift);
      }
      const ModelErrors errors = runOf(moved).result.models.front().errors;
      EXPECT_NEAR(errors.maxPointsDeg, expected.maxPointsDeg, 1e-6) << shift;
      EXPECT_NEAR(errors.rmsPointsDeg, expected.rmsPointsDeg, 1e-6) << shift;
      // The grid of the curve does not move along: its extremes are met to a part of a step.
      EXPECT_NEAR(errors.rmsCurveDeg, expected.rmsCurveDeg, 1e-6) << shift;
    }
  }
}

TEST(Calibration, ErrorsDoNotDependOnDirectionOfMountingOrTravel) {
  const Sweep sweep = sweepOf({}, 48);
  const ModelErrors expected = runOf(sweep).result.models.front().errors;
  Sweep mirrored = sweep;
  for (double& reading : mirrored.sensorDeg) {
    reading = wrap360(360.0 - reading);
  }
  Sweep backwards = sweep;
  std::reverse(backwards.encoderDeg.begin(), backwards.encoderDeg.end());
  std::reverse(backwards.sensorDeg.begin(), backwards.sensorDeg.end());
  for (const Sweep& other : {mirrored, backwards}) {
    const ModelErrors errors = runOf(other).result.models.front().errors;
    EXPECT_NEAR(errors.maxPointsDeg, expected.maxPointsDeg, 1e-9);
    EXPECT_NEAR(errors.maxCurveDeg, expected.maxCurveDeg, 1e-9);
  }
  EXPECT_EQ(runOf(mirrored).result.direction, SensorDirection::Decreasing);
}

TEST(Calibration, SecondIdenticalPassChangesOnlyTheWayToTheCurve) {
  Sweep sweep = sweepOf({}, 64);
  Sweep twice = sweep;
  for (std::size_t i = 0; i < 64; ++i) {
    twice.encoderDeg.push_back(sweep.encoderDeg[i] + 360.0);
    twice.sensorDeg.push_back(sweep.sensorDeg[i]);
  }
  CalibrationOptions options;
  options.curve.method = CurveMethod::Regress;
  const auto once = calibrate(sweep, options, {});
  const auto both = calibrate(twice, options, {});
  ASSERT_TRUE(once.has_value() && both.has_value());
  EXPECT_EQ(both->result.passes.turns, 2);
  EXPECT_LT((once->curve.gridDeg - both->curve.gridDeg).cwiseAbs().maxCoeff(), 1e-7);
}

TEST(Calibration, SameInputGivesTheSameDigits) {
  const CalibrationRun a = sideShaftRun();
  const CalibrationRun b = sideShaftRun();
  EXPECT_EQ(a.curve.gridDeg, b.curve.gridDeg);
  for (std::size_t i = 0; i < a.result.models.size(); ++i) {
    EXPECT_EQ(a.result.models[i].errors.maxCurveDeg, b.result.models[i].errors.maxCurveDeg);
    EXPECT_EQ(a.result.uncertainty[i].expandedDeg, b.result.uncertainty[i].expandedDeg);
  }
}

} // namespace
} // namespace straightedge::angle
