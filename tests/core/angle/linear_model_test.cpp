#include "core/angle/bin_walk.h"
#include "core/angle/linear_model.h"
#include "core/angle/model.h"
#include "tests/core/angle/model_curves.h"

#include <Eigen/QR>
#include <gtest/gtest.h>

#include <cmath>

namespace straightedge::angle {
namespace {

double squaresOf(const Eigen::VectorXd& values, const Eigen::VectorXd& curve) {
  Eigen::VectorXd model(curve.size());
  evaluateLinear({values.data(), static_cast<std::size_t>(values.size())}, model.data(),
                 static_cast<int>(curve.size()));
  return (model - curve).squaredNorm();
}

TEST(BinWalk, visitsEverySampleOnceWithTheBinThatIntegersSay) {
  for (const int count : {gridSize, fineGridSize}) {
    for (int size = 1; size <= 1024; size += (size < 70 ? 1 : 53)) {
      BinWalk walk(size, count);
      int expected = 0;
      for (int k = 0; k < size; ++k, walk.next()) {
        ASSERT_EQ(walk.first(), expected);
        ASSERT_EQ(walk.first(), firstOfBin(k, size, count));
        for (int i = walk.first(); i < walk.first() + walk.samples(); ++i) {
          ASSERT_EQ(static_cast<long long>(i) * size / count, k);
        }
        ASSERT_EQ(walk.into(), static_cast<long long>(walk.first()) * size % count);
        expected += walk.samples();
      }
      ASSERT_EQ(expected, count);
    }
  }
}

TEST(LinearLeastSquares, equalsTheMiddleOfThreeCopiesSideBySide) {
  // The published method: a dense fit of 3·size + 1 free values to three copies and the first sample once more.
  constexpr int samples = 96;
  const Eigen::VectorXd grid = roughGrid(1);
  Eigen::VectorXd curve(samples);
  for (int i = 0; i < samples; ++i) {
    curve[i] = grid[i * (gridSize / samples)];
  }
  for (const int size : {8, 11, 16}) {
    Eigen::MatrixXd hats = Eigen::MatrixXd::Zero(3 * samples + 1, 3 * size + 1);
    Eigen::VectorXd right(3 * samples + 1);
    for (int i = 0; i <= 3 * samples; ++i) {
      const int k = i * size / samples;
      const double t = static_cast<double>(i * size % samples) / samples;
      hats(i, k) += 1.0 - t;
      if (k < 3 * size) {
        hats(i, k + 1) += t;
      }
      right[i] = curve[i % samples];
    }
    const Eigen::VectorXd triple = hats.colPivHouseholderQr().solve(right);
    const Eigen::VectorXd periodic = linearLeastSquares(curve, size);
    // The ends' influence falls by about four per node: with few nodes some of it is left in the published method.
    const double reached = 10.0 * std::pow(3.7, -size);
    EXPECT_LT((triple.segment(size, size) - periodic).cwiseAbs().maxCoeff(), reached) << size;
  }
}

class LeastSquaresSize : public testing::TestWithParam<int> {};

TEST_P(LeastSquaresSize, everyChangeOfANodeMakesItWorse) {
  for (const std::uint32_t seed : {0U, 2U, 4U}) {
    const Eigen::VectorXd curve = roughGrid(seed);
    Eigen::VectorXd values = linearLeastSquares(curve, GetParam());
    const double least = squaresOf(values, curve);
    for (int k = 0; k < GetParam(); k += 1 + GetParam() / 20) {
      for (const double change : {1e-3, -1e-3}) {
        values[k] += change;
        EXPECT_GT(squaresOf(values, curve), least) << "node " << k << " by " << change;
        values[k] -= change;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Linear, LeastSquaresSize, testing::Values(2, 3, 4, 5, 31, 32, 333, 1023, 1024));

TEST(LinearModel, reproducesAPolygonExactly) {
  for (const int size : {2, 3, 8, 100, 1000}) {
    Eigen::VectorXd nodes(size);
    for (int k = 0; k < size; ++k) {
      nodes[k] = 90.0 + 10.0 * ((k * 37) % 11);
    }
    Eigen::VectorXd curve(gridSize);
    evaluateLinear({nodes.data(), static_cast<std::size_t>(size)}, curve.data(), gridSize);
    EXPECT_LT((linearLeastSquares(curve, size) - nodes).cwiseAbs().maxCoeff(), 1e-11) << size;
  }
}

TEST(LinearModel, onCurveTakesTheCurvesOwnValues) {
  const CorrectionCurve& curve = sideShaftCurve();
  for (const int size : {2, 37, 1000}) {
    const auto model = fitModel(curve, {ModelKind::Linear, size, FitMethod::OnCurve, {}});
    ASSERT_TRUE(model);
    for (int k = 0; k < size; ++k) {
      EXPECT_NEAR(std::get<LinearModel>(model->body).valuesDeg[k], curve.at(k * 360.0 / size), 1e-11) << k;
    }
  }
}

} // namespace
} // namespace straightedge::angle
