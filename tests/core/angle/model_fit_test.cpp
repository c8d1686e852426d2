// Fits of every kind against published figures, and what all models have in common.
#include "core/angle/angles.h"
#include "core/angle/model.h"
#include "tests/core/angle/model_curves.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <random>

namespace straightedge::angle {
namespace {

using testing::HasSubstr;

Model fitted(const CorrectionCurve& curve, const char* name) {
  auto parsed = parseModelName(name);
  EXPECT_TRUE(parsed) << parsed.error().message();
  auto model = fitModel(curve, *parsed);
  EXPECT_TRUE(model) << model.error().message();
  return model.value_or(Model{});
}

Error refusal(const CorrectionCurve& curve, const ModelName& name) {
  const auto model = fitModel(curve, name);
  EXPECT_FALSE(model) << name.text();
  return model ? Error{} : model.error();
}

nlohmann::json expectedFigures() {
  return nlohmann::json::parse(std::ifstream(angleData("side_shaft_32_expected.json")));
}

TEST(ModelFit, HarmonicsOfTheSideShaftSweep) {
  const auto expected = expectedFigures()["harmonics"];
  const Model model = fitted(sideShaftCurve(), "harmonic:16");
  const auto& harmonics = std::get<HarmonicModel>(model.body);
  EXPECT_NEAR(harmonics.offsetDeg, expected["offset_deg"].get<double>(), 1e-6);
  ASSERT_EQ(harmonics.terms.size(), 16U);
  for (std::size_t k = 0; k < 16; ++k) {
    const HarmonicTerm& term = harmonics.terms[k];
    EXPECT_EQ(term.order, expected["by_amplitude"][k].get<int>()) << "place " << k;
    const auto& figures = expected["terms"][static_cast<std::size_t>(term.order - 1)];
    EXPECT_NEAR(term.amplitudeDeg, figures["amplitude_deg"].get<double>(), 1e-9) << term.order;
    EXPECT_NEAR(term.phaseRad, figures["phase_rad"].get<double>(), 1e-9) << term.order;
  }
}

TEST(ModelFit, TablesOfTheSideShaftSweep) {
  const auto expected = expectedFigures();
  const Model linear = fitted(sideShaftCurve(), "linear:32");
  const Model table = fitted(sideShaftCurve(), "lut:64");
  for (std::size_t k = 0; k < 32; ++k) {
    EXPECT_NEAR(std::get<LinearModel>(linear.body).valuesDeg[static_cast<Eigen::Index>(k)],
                expected["linear_32_deg"][k].get<double>(), 1e-9);
  }
  for (std::size_t k = 0; k < 64; ++k) {
    EXPECT_NEAR(std::get<LookupTableModel>(table.body).valuesDeg[static_cast<Eigen::Index>(k)],
                expected["lut_64_deg"][k].get<double>(), 1e-9);
  }
}

TEST(ModelFit, ErrorsOfTheSideShaftSweep) {
  const auto expected = expectedFigures()["errors"];
  for (const ModelName& name : defaultModels()) {
    auto model = fitModel(sideShaftCurve(), name);
    ASSERT_TRUE(model) << model.error().message();
    measurePoints(*model, sideShaftAligned());
    const auto& figures = expected[name.text()];
    EXPECT_NEAR(model->errors.maxCurveDeg, figures["max_curve_deg"].get<double>(), 1e-9) << name.text();
    EXPECT_NEAR(model->errors.maxPointsDeg, figures["max_points_deg"].get<double>(), 1e-9) << name.text();
    EXPECT_NEAR(model->errors.rmsCurveDeg, figures["rms_curve_deg"].get<double>(), 1e-9) << name.text();
    EXPECT_NEAR(model->errors.rmsPointsDeg, figures["rms_points_deg"].get<double>(), 1e-9) << name.text();
  }
}

TEST(ModelFit, HarmonicsComeBackWhateverTheSignOfTheOffset) {
  for (const double offset : {89.8, -89.8, -179.5, 179.5, 0.0}) {
    const CorrectionCurve curve = curveOfWaves(offset, {{1, 8.0, 0.7}, {2, 5.0, -1.4}, {64, 0.25, 3.0}});
    const Model model = fitted(curve, "harmonic:3");
    const auto& harmonics = std::get<HarmonicModel>(model.body);
    EXPECT_NEAR(harmonics.offsetDeg, offset, 1e-12);
    EXPECT_EQ(harmonics.terms[2].order, 64);
    EXPECT_NEAR(harmonics.terms[0].amplitudeDeg, 8.0, 1e-12);
    EXPECT_NEAR(harmonics.terms[1].phaseRad, -1.4, 1e-12);
    EXPECT_NEAR(harmonics.terms[2].amplitudeDeg, 0.25, 1e-12);
    EXPECT_NEAR(harmonics.terms[2].phaseRad, 3.0, 1e-11);
    EXPECT_LT(model.errors.maxCurveDeg, 1e-12);
  }
}

TEST(ModelFit, HarmonicsAreChosenByAmplitudeOrInOrder) {
  const CorrectionCurve curve = curveOfWaves(1.0, {{2, 3.0, 0.1}, {4, 5.0, 0.2}, {9, 1.0, 0.3}, {1, 0.5, 0.4}});
  const auto ordersOf = [](const Model& model) {
    std::vector<int> orders;
    for (const HarmonicTerm& term : std::get<HarmonicModel>(model.body).terms) {
      orders.push_back(term.order);
    }
    return orders;
  };
  EXPECT_THAT(ordersOf(fitted(curve, "harmonic:4")), testing::ElementsAre(4, 2, 9, 1));
  EXPECT_THAT(ordersOf(fitted(curve, "harmonic:4@ordered")), testing::ElementsAre(1, 2, 3, 4));
  EXPECT_THAT(ordersOf(fitted(curve, "harmonic:0")), testing::IsEmpty());
}

TEST(ModelFit, HarmonicsThatThePointsDoNotResolveAreNeitherChosenNorFitted) {
  CorrectionCurve curve = curveOfWaves(0.0, {{3, 1.0, 0.0}, {20, 5.0, 0.0}});
  curve.resolvableHarmonics = 8;
  const Model model = fitted(curve, "harmonic:1");
  EXPECT_EQ(std::get<HarmonicModel>(model.body).terms[0].order, 3); // the larger one lies beyond
  for (const char* name : {"harmonic:9", "harmonic:9@ordered"}) {
    const Error error = refusal(curve, *parseModelName(name));
    EXPECT_EQ(error.kind, ErrorKind::Input);
    EXPECT_THAT(error.what, HasSubstr("needs 9 harmonics, but the recorded angles resolve only 8"));
    EXPECT_THAT(error.remedy, HasSubstr("at least 18 distinct angles"));
  }
}

TEST(ModelFit, NamesMadeByHandAreCheckedToo) {
  const CorrectionCurve& curve = sideShaftCurve();
  EXPECT_EQ(refusal(curve, {ModelKind::Linear, 1, FitMethod::LeastSquares, {}}).kind, ErrorKind::Usage);
  EXPECT_EQ(refusal(curve, {ModelKind::Linear, 1025, FitMethod::OnCurve, {}}).kind, ErrorKind::Usage);
  EXPECT_EQ(refusal(curve, {ModelKind::LookupTable, 0, FitMethod::Mean, {}}).kind, ErrorKind::Usage);
  EXPECT_EQ(refusal(curve, {ModelKind::LookupTable, 64, FitMethod::Minimax, {}}).kind, ErrorKind::Usage);
  EXPECT_EQ(refusal(curve, {ModelKind::Linear, 32, FitMethod::LeastSquares, 7}).kind, ErrorKind::Usage);
  EXPECT_EQ(refusal(curve, {ModelKind::Harmonic, 65, FitMethod::Ordered, {}}).kind, ErrorKind::Usage);
}

class EveryModel : public testing::TestWithParam<const char*> {};

TEST_P(EveryModel, reportsTheErrorsOfItsOwnGrid) {
  const CorrectionCurve& curve = sideShaftCurve();
  const Model model = fitted(curve, GetParam());
  const Eigen::VectorXd residual = model.correctionOnGrid() - curve.gridDeg;
  EXPECT_NEAR(model.errors.maxCurveDeg, residual.cwiseAbs().maxCoeff(), 1e-13);
  EXPECT_NEAR(model.errors.rmsCurveDeg, std::sqrt(residual.squaredNorm() / gridSize), 1e-13);
}

TEST_P(EveryModel, saysTheSameOfAReadingAsOnAnyGrid) {
  const Model model = fitted(sideShaftCurve(), GetParam());
  for (const int count : {gridSize, fineGridSize, 360, 1000}) {
    const Eigen::VectorXd grid = model.correctionOnGrid(count);
    for (int i = 0; i < count; i += 7) {
      // Away from a bin's edge by less than rounding: i·360/count itself need not be representable.
      const bool exact = (count & (count - 1)) == 0;
      ASSERT_NEAR(grid[i], model.correctionDeg((i + (exact ? 0.0 : 1e-9)) * 360.0 / count), exact ? 1e-12 : 1e-8)
          << i << " of " << count;
    }
  }
}

TEST_P(EveryModel, takesAnyFiniteReading) {
  const Model model = fitted(sideShaftCurve(), GetParam());
  const double atZero = model.correctionDeg(0.0);
  for (const double turn : {360.0, 720.0, -360.0, -0.0, -1e-17, 3.6e6}) {
    EXPECT_DOUBLE_EQ(model.correctionDeg(turn), atZero) << turn;
  }
  const double justBelow = std::nextafter(360.0, 0.0);
  EXPECT_NEAR(model.correctionDeg(justBelow), model.correctionDeg(360.0 - 1e-9), 1e-7);
  EXPECT_NEAR(model.correctionDeg(-1e-9), model.correctionDeg(360.0 - 1e-9), 1e-12);
  EXPECT_NEAR(model.correctionDeg(1234.5), model.correctionDeg(1234.5 - 1080.0), 1e-9);
  EXPECT_TRUE(std::isnan(model.correctionDeg(std::numeric_limits<double>::quiet_NaN())));
  EXPECT_TRUE(std::isnan(model.correctionDeg(std::numeric_limits<double>::infinity())));
}

TEST_P(EveryModel, correctsIntoOneTurnInBothDirections) {
  const Model model = fitted(sideShaftCurve(), GetParam());
  for (const double sensor : {0.0, 360.0, -1e-17, 720.0, 100.0, 359.999999, 266.31}) {
    const double rising = correctedDeg(model, SensorDirection::Increasing, sensor);
    const double falling = correctedDeg(model, SensorDirection::Decreasing, sensor);
    EXPECT_GE(rising, 0.0);
    EXPECT_LT(rising, 360.0);
    EXPECT_NEAR(wrap180(rising - sensor - model.correctionDeg(sensor)), 0.0, 1e-12);
    EXPECT_NEAR(wrap180(falling + sensor - model.correctionDeg(360.0 - sensor)), 0.0, 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(ModelFit, EveryModel,
                         testing::Values("harmonic:0", "harmonic:4", "harmonic:16@ordered", "harmonic:16/8", "linear:2",
                                         "linear:7", "linear:32", "linear:1024", "linear:37@on-curve",
                                         "linear:32@minimax", "linear:32@minimax/12", "lut:2", "lut:7", "lut:64",
                                         "lut:1024", "lut:1023@midrange", "lut:100/16"));

TEST(ModelFit, PointsErrorsAreWrapped) {
  AlignedSweep aligned;
  aligned.readingDeg = Eigen::Vector3d(1.0, 120.0, 359.0);
  aligned.encoderDeg = Eigen::Vector3d(359.0, 123.0, 1.0);
  Model model;
  model.body = HarmonicModel{};
  measurePoints(model, aligned);
  EXPECT_DOUBLE_EQ(model.errors.maxPointsDeg, 3.0);
  EXPECT_DOUBLE_EQ(model.errors.rmsPointsDeg, std::sqrt(17.0 / 3.0));
}

} // namespace
} // namespace straightedge::angle
