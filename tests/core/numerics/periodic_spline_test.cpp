#include "core/numerics/periodic_spline.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>

namespace straightedge::numerics {
namespace {

/// Uneven knots, two pairs of them close together.
struct Uneven {
  Eigen::VectorXd knots{{3.0, 41.5, 90.0, 97.25, 150.0, 203.0, 260.5, 261.75, 333.0}};
  Eigen::VectorXd values{{1.5, -2.0, 4.25, 4.0, -7.5, 0.25, 3.0, 2.75, -1.0}};
  Eigen::VectorXd bends = periodicSecondDerivatives(knots, values, 360.0);
  PeriodicSpline spline{knots, values, bends, 360.0};
};

// Digits from SciPy 1.10.1, CubicSpline(bc_type='periodic').
TEST(PeriodicSpline, AgreesWithScipy) {
  const Uneven uneven;
  const std::array<std::pair<double, double>, 15> expected = {{{0.0, 1.5071766269100986},
                                                               {1.25, 1.5170124484610072},
                                                               {3.0, 1.5},
                                                               {20.0, -0.1008622001641899},
                                                               {60.0, 0.03890517993607978},
                                                               {93.5, 4.22413597597414},
                                                               {120.0, -0.7294776173429394},
                                                               {180.0, -4.9616717607562455},
                                                               {230.0, 4.47716948514082},
                                                               {261.0, 2.9007564975922926},
                                                               {300.0, -1.9435240749227922},
                                                               {350.0, 0.9080376525068918},
                                                               {359.999, 1.5071617804621253},
                                                               {-45.0, -2.1053314326668406},
                                                               {723.5, 1.4881947886725009}}};
  for (const auto& [x, value] : expected) {
    EXPECT_NEAR(uneven.spline.at(x), value, 1e-12) << x;
  }
  const Eigen::VectorXd bends{{-0.012630745102237292, 0.014285818924094681, -0.014037080095116162,
                               -0.014871753824267309, 0.01488566766422545, -0.0033663836632005623, -0.01104994026893098,
                               0.00398281639543412, 0.004498450165810611}};
  EXPECT_LT((uneven.bends - bends).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(PeriodicSpline, SamplesAreThePointsOfTheSpline) {
  Uneven uneven;
  for (const int count : {1, 2, 7, 360, 4096}) {
    const Eigen::VectorXd samples = uneven.spline.sampled(count);
    ASSERT_EQ(samples.size(), count);
    for (int i = 0; i < count; ++i) {
      EXPECT_NEAR(samples(i), uneven.spline.at(360.0 * i / count), 1e-12) << i << " of " << count;
    }
  }
}

TEST(PeriodicSpline, SamplesOnKnotsAndWithTheFirstKnotAtZero) {
  const Eigen::VectorXd knots{{0.0, 90.0, 180.0, 270.0}};
  const Eigen::VectorXd values{{1.0, 2.0, -1.0, 0.5}};
  const Eigen::VectorXd bends = periodicSecondDerivatives(knots, values, 360.0);
  const PeriodicSpline spline{knots, values, bends, 360.0};
  EXPECT_LT((spline.sampled(4) - values).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_EQ(spline.at(360.0), 1.0);
  EXPECT_EQ(spline.at(-1e-17), 1.0);
}

// The same reference: a spline through the other eight points, for every point.
TEST(PeriodicSpline, LeaveOneOutAgreesWithRefittingInScipy) {
  const Uneven uneven;
  const Eigen::VectorXd expected{{3.9673485580225143, -5.752993266621136, 0.1574182501237118, 0.23603702322246534,
                                  -7.548805830413621, 1.892175441891033, 0.16639268272813768, -0.16577330855917038,
                                  -2.8224608305956416}};
  EXPECT_LT((leaveOneOutResiduals(uneven.spline) - expected).cwiseAbs().maxCoeff(), 1e-11);
}

TEST(PeriodicSpline, LeaveOneOutAgreesWithRefittingForEveryCount) {
  for (Eigen::Index n = 4; n <= 40; ++n) {
    Eigen::VectorXd knots(n);
    Eigen::VectorXd values(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto x = static_cast<double>(i);
      knots(i) = 360.0 * (x + 0.3 * std::sin(5.0 * x)) / static_cast<double>(n) + 20.0;
      values(i) = std::cos(3.0 * x) + 0.1 * x;
    }
    const Eigen::VectorXd bends = periodicSecondDerivatives(knots, values, 360.0);
    const Eigen::VectorXd residuals = leaveOneOutResiduals({knots, values, bends, 360.0});
    for (Eigen::Index left = 0; left < n; ++left) {
      Eigen::VectorXd otherKnots(n - 1);
      Eigen::VectorXd otherValues(n - 1);
      for (Eigen::Index i = 0, j = 0; i < n; ++i) {
        if (i != left) {
          otherKnots(j) = knots(i);
          otherValues(j++) = values(i);
        }
      }
      const Eigen::VectorXd otherBends = periodicSecondDerivatives(otherKnots, otherValues, 360.0);
      const PeriodicSpline others{otherKnots, otherValues, otherBends, 360.0};
      EXPECT_NEAR(residuals(left), values(left) - others.at(knots(left)), 1e-10) << left << " of " << n;
    }
  }
}

} // namespace
} // namespace straightedge::numerics
