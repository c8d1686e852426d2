#include "core/angle/calibration.h"
#include "core/angle/sensor_resolution.h"
#include "core/angle/uncertainty.h"
#include "tests/core/angle/synthetic_sweep.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

namespace straightedge::angle {
namespace {

std::map<std::string, double> byName(const UncertaintyBudget& budget) {
  std::map<std::string, double> figures;
  for (const UncertaintyContribution& contribution : budget.contributions) {
    EXPECT_FALSE(contribution.basis.empty()) << contribution.name;
    figures[contribution.name] = contribution.standardDeg;
  }
  return figures;
}

TEST(Uncertainty, BudgetAsComputedByHand) {
  AlignedSweep aligned;
  aligned.readingDeg = Eigen::VectorXd::LinSpaced(100, 0.0, 359.123456789);
  aligned.passes.noiseDeg = 0.03;
  aligned.passes.repeatabilityDeg = 0.02;
  aligned.passes.hysteresisMaxDeg = 0.06;
  aligned.passes.hysteresisRmsDeg = 0.04;
  CorrectionCurve curve;
  curve.method = CurveMethod::Regress;
  curve.harmonics = 12;
  curve.residualSigmaDeg = 0.06;
  Model model;
  model.errors.rmsCurveDeg = 0.05;
  const UncertaintyBudget budget =
      uncertaintyOf(model, aligned, curve, {.referenceExpandedDeg = 0.01, .sensorResolutionDeg = 0.09});
  const auto figures = byName(budget);
  EXPECT_EQ(budget.model, "harmonic:4");
  EXPECT_NEAR(figures.at("noise"), 0.03, 1e-15);
  EXPECT_NEAR(figures.at("repeatability"), 0.02, 1e-15);
  EXPECT_NEAR(figures.at("hysteresis"), 0.0346410161513775, 1e-15); // 0.06/√3
  EXPECT_NEAR(figures.at("reference"), 0.005, 1e-15);
  EXPECT_NEAR(figures.at("quantisation"), 0.0259807621135332, 1e-15); // 0.09/√12
  // scatter 0.06² less 0.03² + 0.02² + 0.04² leaves 0.0007; standard error 0.06²·25/100 is 0.0009
  EXPECT_NEAR(figures.at("correction curve"), 0.04, 1e-12);
  EXPECT_NEAR(figures.at("model residual"), 0.05, 1e-15);
  // 0.0009 + 0.0004 + 0.0012 + 0.000025 + 0.000675 + 0.0016 + 0.0025 = 0.0073
  EXPECT_NEAR(budget.combinedDeg, std::sqrt(0.0073), 1e-12);
  EXPECT_EQ(budget.coverageFactor, 2.0);
  EXPECT_NEAR(budget.expandedDeg, 2.0 * std::sqrt(0.0073), 1e-12);
}

TEST(Uncertainty, RoundingInsideTheNoiseIsNotCountedTwice) {
  AlignedSweep aligned;
  aligned.readingDeg = Eigen::VectorXd::LinSpaced(100, 0.0, 359.0);
  aligned.passes.noiseDeg = 0.05;
  CorrectionCurve curve;
  curve.residualSigmaDeg = 0.05;
  EXPECT_EQ(byName(uncertaintyOf({}, aligned, curve, {.sensorResolutionDeg = 0.09})).at("quantisation"), 0.0);
  EXPECT_GT(byName(uncertaintyOf({}, aligned, curve, {.sensorResolutionDeg = 0.11})).at("quantisation"), 0.0);
}

TEST(Uncertainty, WhatTheSweepCannotShowIsSaidAndNotCounted) {
  const auto run = calibrate(sweepOf({}, 36), {}, {});
  ASSERT_TRUE(run.has_value());
  const auto figures = byName(run->result.uncertainty.front());
  EXPECT_EQ(figures.at("noise"), 0.0);
  EXPECT_EQ(figures.at("repeatability"), 0.0);
  EXPECT_EQ(figures.at("hysteresis"), 0.0);
  EXPECT_EQ(figures.at("reference"), 0.0);
  EXPECT_EQ(figures.at("correction curve"), run->curve.leaveOneOutRmsDeg);
}

TEST(Uncertainty, StepOfTheSensorIsSeenInTheReadings) {
  Randomness random(3);
  Eigen::VectorXd readings(60);
  const auto quantised = [&](double step, double start) {
    for (double& reading : readings) {
      reading = start + step * std::floor(360.0 / step * random.uniform());
    }
    return estimateResolutionDeg(readings);
  };
  EXPECT_DOUBLE_EQ(quantised(360.0 / 16384.0, 0.0), 360.0 / 16384.0);
  EXPECT_DOUBLE_EQ(quantised(360.0 / 512.0, 75.123), 360.0 / 512.0);
  EXPECT_DOUBLE_EQ(quantised(0.01, 0.0), 0.01);
  for (double& reading : readings) {
    reading = 360.0 * random.uniform();
  }
  EXPECT_EQ(estimateResolutionDeg(readings), 0.0);
}

/// Share of fresh readings whose corrected angle lies within the stated expanded uncertainty of the true one.
double coverage(double noiseDeg, double hysteresisDeg, double quantisationDeg, const std::string& model,
                std::uint64_t seed) {
  const SyntheticSensor sensor;
  Randomness random(seed);
  const auto reading = [&](double shaft, int direction) {
    const double exact = sensor.sensorDeg(shaft) - direction * hysteresisDeg + noiseDeg * random.normal();
    return wrap360(quantisationDeg > 0.0 ? quantisationDeg * std::round(exact / quantisationDeg) : exact);
  };
  std::size_t inside = 0;
  std::size_t all = 0;
  for (int sweepNumber = 0; sweepNumber < 20; ++sweepNumber) {
    Sweep sweep;
    for (int direction = 1; direction >= -1; direction -= 2) {
      for (int i = 0; i < 48 * 3; ++i) {
        const double shaft = 7.5 * (direction > 0 ? i : 48 * 3 - 1 - i);
        sweep.encoderDeg.push_back(shaft);
        sweep.sensorDeg.push_back(reading(shaft, direction));
        sweep.turn.push_back(static_cast<int>(shaft / 360.0));
        sweep.direction.push_back(direction);
        sweep.encoderDeg.push_back(shaft);
        sweep.sensorDeg.push_back(reading(shaft, direction));
        sweep.turn.push_back(static_cast<int>(shaft / 360.0));
        sweep.direction.push_back(direction);
      }
    }
    CalibrationOptions options;
    options.models = {parseModelName(model).value()};
    const auto run = calibrate(sweep, options, {});
    EXPECT_TRUE(run.has_value()) << run.error().message();
    for (int i = 0; i < 500; ++i) {
      const double shaft = 360.0 * random.uniform();
      const int direction = random.uniform() < 0.5 ? 1 : -1;
      const double corrected = correctedDeg(run->result.models[0], run->result.direction, reading(shaft, direction));
      inside += std::abs(wrap180(corrected - shaft)) <= run->result.uncertainty[0].expandedDeg ? 1U : 0U;
      ++all;
    }
  }
  return static_cast<double>(inside) / static_cast<double>(all);
}

// 10,000 fresh readings each: 95 % is known to ± 0.4 % (two standard deviations).
TEST(Uncertainty, CoversFreshReadingsOfANoisySensor) {
  const double share = coverage(0.1, 0.0, 0.0, "linear:64", 1);
  EXPECT_GT(share, 0.93);
  EXPECT_LT(share, 0.97);
}

// A coarse table's residual is larger where the curve is steep, so that its share inside depends on the angle; over the
// whole turn the statement holds.
TEST(Uncertainty, CoversACoarseTableOverTheWholeTurn) {
  const double share = coverage(0.05, 0.0, 0.0, "lut:32", 4);
  EXPECT_GT(share, 0.93);
  EXPECT_LT(share, 0.97);
}

// A loop and a coarse step have no tails: twice their standard deviation holds more than 95 % of them. The
// budget is then on the safe side, which is as far as this bound goes.
TEST(Uncertainty, IsOnTheSafeSideForBoundedContributions) {
  EXPECT_GT(coverage(0.1, 0.1, 0.0, "linear:64", 2), 0.94);
  EXPECT_GT(coverage(0.02, 0.0, 0.2, "linear:64", 3), 0.94);
}

} // namespace
} // namespace straightedge::angle
