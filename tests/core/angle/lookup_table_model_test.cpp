#include "core/angle/lookup_table_model.h"
#include "core/angle/residual_errors.h"
#include "tests/core/angle/model_curves.h"

#include <gtest/gtest.h>

namespace straightedge::angle {
namespace {

ResidualErrors errorsOf(const Eigen::VectorXd& values, const Eigen::VectorXd& curve) {
  Eigen::VectorXd model(curve.size());
  evaluateLookupTable({values.data(), static_cast<std::size_t>(values.size())}, model.data(),
                      static_cast<int>(curve.size()));
  return residualErrors(model.data(), curve.data(), static_cast<std::size_t>(curve.size()));
}

TEST(LookupTable, aSampleOnTheBorderBelongsToTheUpperBin) {
  Eigen::VectorXd grid = Eigen::VectorXd::Zero(gridSize);
  grid[2048] = 64.0; // 180° starts bin 32 of 64
  const Eigen::VectorXd values = lookupTableValues(grid, 64, FitMethod::Mean);
  EXPECT_DOUBLE_EQ(values[32], 1.0);
  EXPECT_DOUBLE_EQ(values[31], 0.0);
  EXPECT_DOUBLE_EQ(lookupTableAt({values.data(), 64}, 180.0), 1.0);
  EXPECT_DOUBLE_EQ(lookupTableAt({values.data(), 64}, 180.0 + 5.624), 1.0);
  EXPECT_DOUBLE_EQ(lookupTableAt({values.data(), 64}, 180.0 + 5.625), 0.0);
  EXPECT_DOUBLE_EQ(lookupTableAt({values.data(), 64}, 179.999), 0.0);
}

class TableSize : public testing::TestWithParam<int> {};

TEST_P(TableSize, meanHasTheLeastRmsAndMidRangeTheLeastMaximum) {
  for (std::uint32_t seed = 0; seed < 6; ++seed) {
    const Eigen::VectorXd curve = roughGrid(seed);
    Eigen::VectorXd mean = lookupTableValues(curve, GetParam(), FitMethod::Mean);
    const Eigen::VectorXd middle = lookupTableValues(curve, GetParam(), FitMethod::MidRange);
    const ResidualErrors ofMean = errorsOf(mean, curve);
    const ResidualErrors ofMiddle = errorsOf(middle, curve);
    EXPECT_LE(ofMiddle.maxAbs, ofMean.maxAbs + 1e-12);
    EXPECT_LE(ofMean.rms, ofMiddle.rms + 1e-12);
    for (const double change : {1e-3, -1e-3}) {
      mean[GetParam() / 2] += change;
      EXPECT_GT(errorsOf(mean, curve).rms, ofMean.rms);
      mean[GetParam() / 2] -= change;
    }
  }
}

TEST_P(TableSize, midRangeLeavesHalfTheRangeOfEveryBin) {
  const Eigen::VectorXd curve = roughGrid(3);
  const Eigen::VectorXd middle = lookupTableValues(curve, GetParam(), FitMethod::MidRange);
  Eigen::VectorXd least = Eigen::VectorXd::Constant(GetParam(), 1e9);
  Eigen::VectorXd most = -least;
  for (int i = 0; i < gridSize; ++i) {
    const int bin = i * GetParam() / gridSize;
    least[bin] = std::min(least[bin], curve[i]);
    most[bin] = std::max(most[bin], curve[i]);
  }
  EXPECT_NEAR(errorsOf(middle, curve).maxAbs, 0.5 * (most - least).maxCoeff(), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(LookupTable, TableSize, testing::Values(2, 3, 7, 64, 255, 256, 300, 1000, 1024));

} // namespace
} // namespace straightedge::angle
