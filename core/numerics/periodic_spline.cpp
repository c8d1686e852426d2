#include "core/numerics/periodic_spline.h"

#include "core/numerics/cyclic_tridiagonal.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace straightedge::numerics {

namespace {

Eigen::VectorXd intervals(const Eigen::VectorXd& knots, double period) {
  const Eigen::Index n = knots.size();
  Eigen::VectorXd width(n);
  width.head(n - 1) = knots.tail(n - 1) - knots.head(n - 1);
  width(n - 1) = knots(0) + period - knots(n - 1);
  assert(width.minCoeff() > 0.0);
  return width;
}

CyclicTridiagonal bendingSystem(const Eigen::VectorXd& width) {
  const Eigen::Index n = width.size();
  Eigen::VectorXd diagonal(n);
  diagonal(0) = (width(n - 1) + width(0)) / 3.0;
  diagonal.tail(n - 1) = (width.head(n - 1) + width.tail(n - 1)) / 3.0;
  return {diagonal, width / 6.0};
}

/// One piece as a cubic in the distance from its left knot.
struct Piece {
  double value, slope, halfCurvature, sixthJerk;
  double at(double t) const { return value + t * (slope + t * (halfCurvature + t * sixthJerk)); }
};

Piece pieceAt(const PeriodicSpline& spline, Eigen::Index i) {
  const Eigen::Index n = spline.knots.size();
  const Eigen::Index j = i + 1 == n ? 0 : i + 1;
  const double width = (i + 1 == n ? spline.knots(0) + spline.period : spline.knots(j)) - spline.knots(i);
  const double m0 = spline.secondDerivatives(i);
  const double m1 = spline.secondDerivatives(j);
  return {spline.values(i), (spline.values(j) - spline.values(i)) / width - width * (2.0 * m0 + m1) / 6.0, 0.5 * m0,
          (m1 - m0) / (6.0 * width)};
}

} // namespace

Eigen::VectorXd periodicSecondDerivatives(const Eigen::VectorXd& knots, const Eigen::VectorXd& values, double period) {
  const Eigen::Index n = knots.size();
  assert(n >= 3 && values.size() == n);
  const Eigen::VectorXd width = intervals(knots, period);
  Eigen::VectorXd slope(n);
  slope.head(n - 1) = (values.tail(n - 1) - values.head(n - 1)).cwiseQuotient(width.head(n - 1));
  slope(n - 1) = (values(0) - values(n - 1)) / width(n - 1);
  Eigen::VectorXd bend(n);
  bend(0) = slope(0) - slope(n - 1);
  bend.tail(n - 1) = slope.tail(n - 1) - slope.head(n - 1);
  return bendingSystem(width).solve(bend);
}

double PeriodicSpline::at(double x) const {
  double offset = std::fmod(x - knots(0), period);
  if (offset < 0.0) {
    offset += period;
  }
  const double inside = knots(0) + offset;
  const double* end = knots.data() + knots.size();
  const auto right = std::upper_bound(knots.data(), end, inside) - knots.data();
  const Eigen::Index i = std::max<Eigen::Index>(right - 1, 0);
  return pieceAt(*this, i).at(inside - knots(i));
}

Eigen::VectorXd PeriodicSpline::sampled(int count) const {
  Eigen::VectorXd result(count);
  const double step = period / count;
  const Eigen::Index n = knots.size();
  const auto firstAtOrAfter = [&](double x) {
    auto i = static_cast<int>(std::ceil(x / step));
    while (i > 0 && step * (i - 1) >= x) {
      --i;
    }
    while (step * i < x) {
      ++i;
    }
    return i;
  };
  const int begin = firstAtOrAfter(knots(0));
  int from = begin;
  for (Eigen::Index i = 0; i < n; ++i) {
    const Piece piece = pieceAt(*this, i);
    const double knot = knots(i);
    const int to = i + 1 < n ? std::min(firstAtOrAfter(knots(i + 1)), count) : count;
    for (int k = from; k < to; ++k) {
      result(k) = piece.at(step * k - knot);
    }
    from = std::max(from, to);
  }
  // The stretch before the first knot belongs to the last piece, one period on.
  const Piece piece = pieceAt(*this, n - 1);
  for (int k = 0; k < std::min(begin, count); ++k) {
    result(k) = piece.at(step * k + (period - knots(n - 1)));
  }
  return result;
}

Eigen::VectorXd leaveOneOutResiduals(const PeriodicSpline& spline) {
  const Eigen::Index n = spline.knots.size();
  assert(n >= 4);
  const Eigen::VectorXd inverseWidth = intervals(spline.knots, spline.period).cwiseInverse();
  const auto band = bendingSystem(intervals(spline.knots, spline.period)).inverseBand();
  const Eigen::VectorXd& m = spline.secondDerivatives;
  Eigen::VectorXd residuals(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index before = i == 0 ? n - 1 : i - 1;
    const Eigen::Index after = i + 1 == n ? 0 : i + 1;
    // Column i of Q: what the value at knot i does to the bends at its neighbours and itself.
    const double left = inverseWidth(before);
    const double right = inverseWidth(i);
    const double own = -(left + right);
    const double energyGradient = left * m(before) + own * m(i) + right * m(after);
    const double stiffness =
        left * left * band.diagonal(before) + own * own * band.diagonal(i) + right * right * band.diagonal(after) +
        2.0 * (left * own * band.next(before) + own * right * band.next(i) + left * right * band.afterNext(before));
    residuals(i) = energyGradient / stiffness;
  }
  return residuals;
}

} // namespace straightedge::numerics
