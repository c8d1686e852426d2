#include "core/angle/calibration.h"
#include "core/angle/sweep_csv.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <string>

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

} // namespace
} // namespace straightedge::angle
