#include "core/angle/curve.h"
#include "core/angle/sweep_csv.h"
#include "tests/core/angle/synthetic_sweep.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <fstream>
#include <numbers>
#include <string>
#include <utility>

namespace straightedge::angle {
namespace {

const std::string dataFolder = STRAIGHTEDGE_TEST_DATA "/angle/";

Sweep sideShaft() {
  auto sweep = readSweepCsv(dataFolder + "side_shaft_32.csv");
  EXPECT_TRUE(sweep.has_value());
  return sweep.value_or(Sweep{});
}

std::complex<double> harmonicOf(const Eigen::VectorXd& grid, int order) {
  std::complex<double> sum = 0.0;
  for (Eigen::Index i = 0; i < grid.size(); ++i) {
    const double phase = -2.0 * std::numbers::pi * order * static_cast<double>(i) / static_cast<double>(grid.size());
    sum += grid(i) * std::polar(1.0, phase);
  }
  return sum / static_cast<double>(grid.size());
}

TEST(Curve, SideShaftAgreesWithThePublishedMethodToAMillionth) {
  const auto aligned = alignSweep(sideShaft());
  ASSERT_TRUE(aligned.has_value()) << aligned.error().message();
  const auto curve = fitCurve(*aligned);
  ASSERT_TRUE(curve.has_value()) << curve.error().message();
  EXPECT_EQ(curve->method, CurveMethod::Interpolate);
  EXPECT_EQ(curve->resolvableHarmonics, 16);
  const auto expected = nlohmann::json::parse(std::ifstream(dataFolder + "side_shaft_32_expected.json"));
  EXPECT_NEAR(curve->gridDeg.mean(), expected["harmonics"]["offset_deg"].get<double>(), 1e-6);
  for (int order = 1; order <= 16; ++order) {
    const std::complex<double> harmonic = 2.0 * harmonicOf(curve->gridDeg, order);
    const auto index = static_cast<std::size_t>(order - 1);
    EXPECT_NEAR(std::abs(harmonic), expected["harmonics"]["terms"][index]["amplitude_deg"].get<double>(), 1e-6)
        << order;
    EXPECT_NEAR(std::arg(harmonic), expected["harmonics"]["terms"][index]["phase_rad"].get<double>(), 1e-6) << order;
  }
}

CorrectionCurve curveOf(const Sweep& sweep, CurveMethod method = CurveMethod::Auto) {
  const auto aligned = alignSweep(sweep);
  EXPECT_TRUE(aligned.has_value()) << aligned.error().message();
  auto curve = fitCurve(aligned.value(), {.method = method});
  EXPECT_TRUE(curve.has_value()) << curve.error().message();
  return std::move(curve.value());
}

double largestMiss(const CorrectionCurve& curve, const SyntheticSensor& sensor) {
  double largest = 0.0;
  for (int i = 0; i < gridSize; ++i) {
    const double reading = 360.0 * i / gridSize;
    largest = std::max(largest, std::abs(wrap180(curve.gridDeg(i) - sensor.correctionDeg(reading))));
  }
  return largest;
}

// Reference digits: SciPy 1.10.1, a periodic CubicSpline through the other 31 points for every point.
TEST(Curve, LeaveOneOutOfTheSideShaftSplineIsThatOfRefitting) {
  const CorrectionCurve curve = curveOf(sideShaft());
  EXPECT_NEAR(curve.leaveOneOutRmsDeg, 0.21299636068769565, 1e-9);
  EXPECT_NEAR(curve.leaveOneOutMaxDeg, 0.43044753558423565, 1e-9);
  EXPECT_FALSE(curve.residualSigmaDeg.has_value());
}

// Reference digits: NumPy 1.24, QR factors of the whole design matrix, leverages from its rows.
TEST(Curve, RegressionOfTheSideShaftSweepChoosesSixHarmonics) {
  const CorrectionCurve curve = curveOf(sideShaft(), CurveMethod::Regress);
  EXPECT_EQ(curve.method, CurveMethod::Regress);
  EXPECT_EQ(curve.harmonics, 6);
  const std::array<double, 15> rms = {7.183207959323512,   4.340373012335889,   0.9979368193057172,  0.4475480098752502,
                                      0.245618651281589,   0.16087272664824182, 0.14357588446359257, 0.1527279606550791,
                                      0.16714327792513703, 0.16930387190510288, 0.1947643302930772,  0.2516351449237407,
                                      0.33902548698187085, 1.177086387444688,   3.887796500904435};
  ASSERT_GE(curve.crossValidationRmsDeg.size(), rms.size());
  for (std::size_t i = 0; i < rms.size(); ++i) {
    EXPECT_NEAR(curve.crossValidationRmsDeg[i], rms[i], 1e-8) << i;
  }
  EXPECT_NEAR(curve.leaveOneOutRmsDeg, 0.14357588446359257, 1e-9);
  EXPECT_NEAR(curve.leaveOneOutMaxDeg, 0.2806567553630416, 1e-9);
  EXPECT_NEAR(curve.residualSigmaDeg.value_or(0.0), 0.11459474011375581, 1e-9);
  EXPECT_NEAR(curve.trigonometric.offsetDeg, 89.821202716737, 1e-9);
  EXPECT_NEAR(curve.trigonometric.cosine(0), 6.409642754742306, 1e-9);
  EXPECT_NEAR(curve.trigonometric.sine(5), 0.08040839499935276, 1e-9);
}

TEST(Curve, InterpolationNeedsReadingsThatDoNotRepeat) {
  Sweep sweep = sweepOf({}, 36);
  sweep.encoderDeg.push_back(sweep.encoderDeg[3] + 360.0);
  sweep.sensorDeg.push_back(sweep.sensorDeg[3]);
  const auto aligned = alignSweep(sweep);
  ASSERT_TRUE(aligned.has_value());
  const auto refused = fitCurve(*aligned, {.method = CurveMethod::Interpolate});
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().kind, ErrorKind::Input);
  EXPECT_EQ(refused.error().message(),
            "readings repeat or step back, so no curve can pass through every point; use the curve 'regress' (or "
            "'auto'), which runs between them");
  EXPECT_EQ(curveOf(sweep).method, CurveMethod::Regress);
}

TEST(Curve, AutoInterpolatesWhatRisesAndRegressesWhatStepsBack) {
  Sweep sweep = sweepOf({}, 36);
  EXPECT_EQ(curveOf(sweep).method, CurveMethod::Interpolate);
  sweep.sensorDeg[20] = wrap360(sweep.sensorDeg[20] - 12.0);
  EXPECT_EQ(curveOf(sweep).method, CurveMethod::Regress);
}

TEST(Curve, KnownTruthComesBack) {
  for (const bool decreasing : {false, true}) {
    for (const double offset : {-95.0, 0.0, 179.9, -180.0, 250.0}) {
      SyntheticSensor sensor;
      sensor.offsetDeg = offset;
      sensor.decreasing = decreasing;
      // The spline's error falls with the fourth power of the distance.
      EXPECT_LT(largestMiss(curveOf(sweepOf(sensor, 64)), sensor), 5e-3) << offset;
      EXPECT_LT(largestMiss(curveOf(sweepOf(sensor, 256)), sensor), 2e-5) << offset;
      EXPECT_LT(largestMiss(curveOf(sweepOf(sensor, 128), CurveMethod::Regress), sensor), 1e-6) << offset;
      const CorrectionCurve curve = curveOf(sweepOf(sensor, 64));
      EXPECT_GE(curve.gridDeg.mean(), -180.0);
      EXPECT_LT(curve.gridDeg.mean(), 180.0);
    }
  }
}

TEST(Curve, RegressionRunsBetweenNoisyRepeats) {
  const SyntheticSensor sensor;
  Randomness random(8);
  Sweep sweep;
  for (int turn = 0; turn < 4; ++turn) {
    for (int i = 0; i < 90; ++i) {
      sweep.encoderDeg.push_back(360.0 * turn + 4.0 * i);
      sweep.sensorDeg.push_back(wrap360(sensor.sensorDeg(4.0 * i) + 0.1 * random.normal()));
    }
  }
  const CorrectionCurve curve = curveOf(sweep);
  EXPECT_EQ(curve.method, CurveMethod::Regress);
  EXPECT_NEAR(curve.residualSigmaDeg.value_or(0.0), 0.1, 0.015);
  EXPECT_GE(curve.harmonics, 4);
  EXPECT_LE(curve.harmonics, 20);
  // About 25 coefficients from 360 points: standard error 0.1·√(25/360), four times that at the worst angle.
  EXPECT_LT(largestMiss(curve, sensor), 0.11);
}

TEST(Curve, AtAndSampledAreTheGrid) {
  for (const CurveMethod method : {CurveMethod::Interpolate, CurveMethod::Regress}) {
    SyntheticSensor sensor;
    sensor.offsetDeg = 175.0;
    const CorrectionCurve curve = curveOf(sweepOf(sensor, 36), method);
    EXPECT_LT((curve.sampled(gridSize) - curve.gridDeg).cwiseAbs().maxCoeff(), 1e-9);
    for (int i = 0; i < gridSize; i += 37) {
      const double reading = 360.0 * i / gridSize;
      EXPECT_NEAR(curve.at(reading), curve.gridDeg(i), 1e-9);
      EXPECT_NEAR(curve.at(reading - 720.0), curve.gridDeg(i), 1e-9);
    }
    EXPECT_EQ(curve.at(360.0), curve.at(0.0));
  }
}

TEST(Curve, ResolvesHalfTheDistinctAnglesAndAtMost64) {
  EXPECT_EQ(curveOf(sweepOf({}, 35)).resolvableHarmonics, 17);
  EXPECT_EQ(curveOf(sweepOf({}, 500)).resolvableHarmonics, 64);
}

TEST(Curve, HundredThousandNoisyRows) {
  const SyntheticSensor sensor;
  Sweep sweep = sweepOf(sensor, 100000);
  Randomness random(21);
  for (double& reading : sweep.sensorDeg) {
    reading = wrap360(reading + 0.1 * random.normal());
  }
  const CorrectionCurve curve = curveOf(sweep);
  EXPECT_EQ(curve.method, CurveMethod::Regress);
  EXPECT_NEAR(curve.residualSigmaDeg.value_or(0.0), 0.1, 0.005);
  EXPECT_LT(largestMiss(curve, sensor), 0.02);
}

} // namespace
} // namespace straightedge::angle
