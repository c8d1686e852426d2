// Periodic cubic spline through points on a circle, and how well it foretells each point from the others.
//
// Second derivatives M at the knots solve the cyclic, symmetric, positive definite system R·M = Q·y with
//   R(i,i) = (h(i−1)+h(i))/3, R(i,i±1) = h/6, (Q·y)(i) = (y(i+1)−y(i))/h(i) − (y(i)−y(i−1))/h(i−1)
// (de Boor, A Practical Guide to Splines, chapter IV; Green and Silverman, Nonparametric Regression, section 2.1).
#pragma once

#include <Eigen/Core>

namespace straightedge::numerics {

/// A spline as three vectors that somebody else owns. Knots strictly ascending, all within one period
/// (last − first < period), at least 3 of them (asserted).
struct PeriodicSpline {
  const Eigen::VectorXd& knots;
  const Eigen::VectorXd& values;
  const Eigen::VectorXd& secondDerivatives;
  double period = 360.0;

  double at(double x) const; ///< any finite x
  /// Values at i·period/count, i = 0 … count−1, in one walk over the knots, which must then lie in [0, period).
  Eigen::VectorXd sampled(int count) const;
};

/// The second derivatives that make the spline through (knots, values) twice differentiable all round.
Eigen::VectorXd periodicSecondDerivatives(const Eigen::VectorXd& knots, const Eigen::VectorXd& values, double period);

/// For every knot i: value(i) minus what the periodic spline through all other knots says there. Exact, O(n) in all:
/// the spline minimises the bending energy yᵀ·K·y, K = Qᵀ·R⁻¹·Q, so leaving out i means minimising over y(i), and the
/// difference is (K·y)(i) / K(i,i). Needs at least 4 knots.
Eigen::VectorXd leaveOneOutResiduals(const PeriodicSpline& spline);

} // namespace straightedge::numerics
