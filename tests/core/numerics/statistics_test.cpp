#include "core/numerics/statistics.h"

#include <gtest/gtest.h>

namespace straightedge::numerics {
namespace {

TEST(Statistics, MedianOfOddEvenAndNothing) {
  EXPECT_EQ(median({3.0, 1.0, 2.0}), 2.0);
  EXPECT_EQ(median({4.0, 1.0, 3.0, 2.0}), 2.5);
  EXPECT_EQ(median({}), 0.0);
}

TEST(Statistics, RootMeanSquareAndLargest) {
  EXPECT_DOUBLE_EQ(rootMeanSquare(Eigen::VectorXd{{3.0, -4.0}}), 3.5355339059327378);
  EXPECT_EQ(largestMagnitude(Eigen::VectorXd{{3.0, -4.0}}), 4.0);
  EXPECT_EQ(rootMeanSquare({}), 0.0);
  EXPECT_EQ(largestMagnitude({}), 0.0);
}

TEST(Statistics, PooledDeviationWeighsByDegreesOfFreedom) {
  PooledDeviation pooled;
  EXPECT_FALSE(pooled.isKnown());
  pooled.add(123.0, 1); // one value says nothing about scatter
  EXPECT_FALSE(pooled.isKnown());
  pooled.add(2.0, 2);
  pooled.add(10.0, 4);
  EXPECT_EQ(pooled.degreesOfFreedom(), 4U);
  EXPECT_DOUBLE_EQ(pooled.variance(), 3.0);
}

} // namespace
} // namespace straightedge::numerics
