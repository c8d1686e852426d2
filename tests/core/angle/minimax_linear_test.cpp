// Minimax fits. That a fit is optimal is proven without the solver: its weights on the samples are checked to cancel at
// every node, which makes Σ w·c a lower bound of the maximum error of every polygon of that size (weak duality, see
// minimax_linear.h), and the fitted polygon's own maximum error is measured and must meet that bound.
#include "core/angle/linear_model.h"
#include "core/angle/minimax_linear.h"
#include "core/angle/model.h"
#include "tests/core/angle/model_curves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stop_token>

namespace straightedge::angle {
namespace {

double measuredMaximum(const Eigen::VectorXd& nodes, const Eigen::VectorXd& curve) {
  double most = 0.0;
  const auto size = static_cast<int>(nodes.size());
  for (int i = 0; i < gridSize; ++i) {
    const int k = i * size / gridSize;
    const double t = static_cast<double>(i * size % gridSize) / gridSize;
    most = std::max(most, std::abs((1.0 - t) * nodes[k] + t * nodes[(k + 1) % size] - curve[i]));
  }
  return most;
}

void expectProven(const MinimaxLinear& fit, const Eigen::VectorXd& curve, int size) {
  ASSERT_EQ(fit.valuesDeg.size(), size);
  const double swing = curve.maxCoeff() - curve.minCoeff();
  const double maximum = measuredMaximum(fit.valuesDeg, curve);
  EXPECT_NEAR(fit.maxErrorDeg, maximum, 1e-12 * (swing + curve.cwiseAbs().maxCoeff()));
  Eigen::VectorXd atNode = Eigen::VectorXd::Zero(size);
  double total = 0.0;
  double bound = 0.0;
  double offset = curve[0]; // weights sum to zero, so a constant may be taken off: less rounding
  for (const MinimaxProof::Weight& weight : fit.proof.weights) {
    ASSERT_GE(weight.sample, 0);
    ASSERT_LT(weight.sample, gridSize);
    const int k = weight.sample * size / gridSize;
    const double t = static_cast<double>(weight.sample * size % gridSize) / gridSize;
    atNode[k] += weight.value * (1.0 - t);
    atNode[(k + 1) % size] += weight.value * t;
    total += std::abs(weight.value);
    bound += weight.value * (curve[weight.sample] - offset);
  }
  EXPECT_NEAR(total, 1.0, 1e-12);
  EXPECT_LT(atNode.cwiseAbs().maxCoeff(), 1e-12) << "size " << size;
  EXPECT_LE(bound, maximum + 1e-9 * swing) << "size " << size;
  EXPECT_GE(bound, maximum - 1e-9 * swing) << "size " << size; // no polygon of this size does better
  EXPECT_NEAR(bound, fit.proof.lowerBoundDeg, 1e-9 * swing);
}

TEST(MinimaxLinear, isProvenOptimalAtEverySizeOfTheComparison) {
  const Eigen::VectorXd& curve = sideShaftCurve().gridDeg;
  for (int size = 2; size <= 1024; size = size < 64 ? size + 1 : 2 * size) {
    const auto fit = linearMinimax(curve, size);
    ASSERT_TRUE(fit);
    expectProven(*fit, curve, size);
  }
}

TEST(MinimaxLinear, isNeverWorseThanOtherWays) {
  const CorrectionCurve& curve = sideShaftCurve();
  for (int size = 2; size <= 64; ++size) {
    const auto minimax = fitModel(curve, {ModelKind::Linear, size, FitMethod::Minimax, {}});
    const auto leastSquares = fitModel(curve, {ModelKind::Linear, size, FitMethod::LeastSquares, {}});
    const auto onCurve = fitModel(curve, {ModelKind::Linear, size, FitMethod::OnCurve, {}});
    ASSERT_TRUE(minimax && leastSquares && onCurve);
    EXPECT_LE(minimax->errors.maxCurveDeg, leastSquares->errors.maxCurveDeg) << size;
    EXPECT_LE(minimax->errors.maxCurveDeg, onCurve->errors.maxCurveDeg) << size;
    EXPECT_GE(minimax->errors.rmsCurveDeg, leastSquares->errors.rmsCurveDeg) << size;
  }
}

class RoughCurve : public testing::TestWithParam<std::uint32_t> {};

TEST_P(RoughCurve, isFittedWithProof) {
  const Eigen::VectorXd curve = roughGrid(GetParam());
  for (const int size : {2, 3, 5, 8, 31, 32, 63, 100, 333, 512, 999, 1024}) {
    const auto fit = linearMinimax(curve, size);
    ASSERT_TRUE(fit);
    expectProven(*fit, curve, size);
  }
}

INSTANTIATE_TEST_SUITE_P(Minimax, RoughCurve, testing::Range(0U, 12U));

TEST(MinimaxLinear, reproducesWhatIsAPolygonAlready) {
  Eigen::VectorXd nodes(12);
  nodes << 1, 5, 2, 8, -3, 0, 4, 4, 4, -7, 2, 6;
  Eigen::VectorXd curve(gridSize);
  evaluateLinear({nodes.data(), 12}, curve.data(), gridSize);
  const auto same = linearMinimax(curve, 12);
  ASSERT_TRUE(same);
  EXPECT_LT(same->maxErrorDeg, 1e-11);
  EXPECT_LT((same->valuesDeg - nodes).cwiseAbs().maxCoeff(), 1e-9);
  const auto constant = linearMinimax(Eigen::VectorXd::Constant(gridSize, 42.0), 7);
  ASSERT_TRUE(constant);
  EXPECT_EQ(constant->maxErrorDeg, 0.0);
  EXPECT_EQ(constant->valuesDeg, Eigen::VectorXd::Constant(7, 42.0));
}

TEST(MinimaxLinear, ofASingleSpikeIsHalfOfIt) {
  Eigen::VectorXd curve = Eigen::VectorXd::Zero(gridSize);
  curve[1000] = 4.0; // neighbours stay at zero: no polygon with wide segments can follow
  const auto fit = linearMinimax(curve, 4);
  ASSERT_TRUE(fit);
  expectProven(*fit, curve, 4);
  EXPECT_NEAR(fit->maxErrorDeg, 2.0, 0.02);
}

TEST(MinimaxLinear, stopsWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  const auto fit = linearMinimax(sideShaftCurve().gridDeg, 32, JobControl{stop.get_token(), {}});
  ASSERT_FALSE(fit);
  EXPECT_EQ(fit.error().kind, ErrorKind::Cancelled);
}

} // namespace
} // namespace straightedge::angle
