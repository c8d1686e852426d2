#include "core/numerics/trigonometric_fit.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

namespace straightedge::numerics {
namespace {

double truth(double deg) {
  const double x = deg * std::numbers::pi / 180.0;
  return -75.0 + 3.0 * std::cos(x) - 2.0 * std::sin(x) + 0.5 * std::cos(3.0 * x) + 0.25 * std::sin(5.0 * x);
}

/// Uneven angles, the quarter from 100° to 150° rather empty.
Eigen::VectorXd unevenAngles(Eigen::Index count) {
  Eigen::VectorXd deg(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count);
    deg(i) = 150.0 + 310.0 * share + 3.0 * std::sin(40.0 * share);
  }
  return deg;
}

std::vector<std::size_t> eachAlone(Eigen::Index count) {
  std::vector<std::size_t> group(static_cast<std::size_t>(count));
  std::iota(group.begin(), group.end(), std::size_t{0});
  return group;
}

TEST(TrigonometricFit, FindsATrueSeriesAndItsNumberOfHarmonics) {
  const Eigen::VectorXd deg = unevenAngles(60);
  const Eigen::VectorXd values = deg.unaryExpr(&truth);
  const TrigonometricFit fit = fitTrigonometric(deg, values, eachAlone(60), 60, 25);
  EXPECT_EQ(fit.harmonics, 5);
  EXPECT_NEAR(fit.offset, -75.0, 1e-9);
  EXPECT_LT((fit.cosine - Eigen::VectorXd{{3.0, 0.0, 0.5, 0.0, 0.0}}).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((fit.sine - Eigen::VectorXd{{-2.0, 0.0, 0.0, 0.0, 0.25}}).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT(fit.residualSigma, 1e-9);
  for (const double x : {-50.0, 0.0, 123.0, 359.9}) {
    EXPECT_NEAR(trigonometricAt(fit.offset, fit.cosine, fit.sine, x), truth(x), 1e-9);
  }
  const Eigen::VectorXd samples = trigonometricSampled(fit.offset, fit.cosine, fit.sine, 1000);
  for (int i = 0; i < 1000; ++i) {
    EXPECT_NEAR(samples(i), truth(0.36 * i), 1e-9);
  }
}

TEST(TrigonometricFit, LeftOutResidualsAreThoseOfRefittingWithoutTheGroup) {
  // 20 angles, read one to three times each; a ragged function that no number of harmonics fits.
  std::vector<double> angles;
  std::vector<double> readings;
  std::vector<std::size_t> group;
  for (std::size_t g = 0; g < 20; ++g) {
    for (std::size_t repeat = 0; repeat <= g % 3; ++repeat) {
      angles.push_back(18.0 * static_cast<double>(g) + 4.0 * std::sin(static_cast<double>(g)));
      readings.push_back(truth(angles.back()) + std::cos(static_cast<double>(7 * g + 3 * repeat)));
      group.push_back(g);
    }
  }
  const auto count = static_cast<Eigen::Index>(angles.size());
  const Eigen::VectorXd deg = Eigen::Map<Eigen::VectorXd>(angles.data(), count);
  const Eigen::VectorXd values = Eigen::Map<Eigen::VectorXd>(readings.data(), count);
  for (const int harmonics : {0, 2, 4}) {
    const TrigonometricFit fit = fitTrigonometric(deg, values, group, 20, harmonics);
    double squares = 0.0;
    for (std::size_t left = 0; left < 20; ++left) {
      std::vector<double> otherAngles;
      std::vector<double> otherReadings;
      for (std::size_t i = 0; i < angles.size(); ++i) {
        if (group[i] != left) {
          otherAngles.push_back(angles[i]);
          otherReadings.push_back(readings[i]);
        }
      }
      const auto others = static_cast<Eigen::Index>(otherAngles.size());
      // Straight from the definition: a dense least-squares problem.
      Eigen::MatrixXd design(others, 2 * harmonics + 1);
      for (Eigen::Index row = 0; row < others; ++row) {
        const double x = otherAngles[static_cast<std::size_t>(row)] * std::numbers::pi / 180.0;
        design(row, 0) = 1.0;
        for (int k = 1; k <= harmonics; ++k) {
          design(row, 2 * k - 1) = std::cos(k * x);
          design(row, 2 * k) = std::sin(k * x);
        }
      }
      const Eigen::VectorXd solution = (design.transpose() * design).inverse() * design.transpose() *
                                       Eigen::Map<Eigen::VectorXd>(otherReadings.data(), others);
      for (std::size_t i = 0; i < angles.size(); ++i) {
        if (group[i] == left) {
          const double x = angles[i] * std::numbers::pi / 180.0;
          double foretold = solution(0);
          for (int k = 1; k <= harmonics; ++k) {
            foretold += solution(2 * k - 1) * std::cos(k * x) + solution(2 * k) * std::sin(k * x);
          }
          squares += (readings[i] - foretold) * (readings[i] - foretold);
          if (fit.harmonics == harmonics) {
            EXPECT_NEAR(fit.leftOutResiduals(static_cast<Eigen::Index>(i)), readings[i] - foretold, 1e-10);
          }
        }
      }
    }
    EXPECT_NEAR(fit.leftOutRms.back(), std::sqrt(squares / static_cast<double>(count)), 1e-10) << harmonics;
  }
}

TEST(TrigonometricFit, RepeatsDoNotForetellOneAnother) {
  // Every angle five times with one and the same error: left out singly, its twins would foretell it.
  Eigen::VectorXd deg(200);
  Eigen::VectorXd values(200);
  std::vector<std::size_t> group(200);
  for (Eigen::Index i = 0; i < 200; ++i) {
    const Eigen::Index g = i / 5;
    deg(i) = 9.0 * static_cast<double>(g);
    values(i) = truth(deg(i)) + 0.5 * std::cos(static_cast<double>(97 * g * g));
    group[static_cast<std::size_t>(i)] = static_cast<std::size_t>(g);
  }
  const TrigonometricFit together = fitTrigonometric(deg, values, group, 40, 19);
  const TrigonometricFit singly = fitTrigonometric(deg, values, eachAlone(200), 200, 19);
  EXPECT_LE(together.harmonics, 8);
  EXPECT_GT(singly.harmonics, 12);
}

TEST(TrigonometricFit, StopsWhereThePointsNoLongerDetermineTheCoefficients) {
  const Eigen::VectorXd deg = Eigen::VectorXd::LinSpaced(60, 0.0, 270.0);
  const Eigen::VectorXd values = deg.unaryExpr(&truth);
  const TrigonometricFit fit = fitTrigonometric(deg, values, eachAlone(60), 60, 29);
  EXPECT_LT(fit.leftOutRms.size(), 29U) << "a quarter without points leaves the higher harmonics undetermined";
  EXPECT_GE(fit.leftOutRms.size(), 6U);
  for (const double rms : fit.leftOutRms) {
    EXPECT_TRUE(std::isfinite(rms));
  }
}

} // namespace
} // namespace straightedge::numerics
