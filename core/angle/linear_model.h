// Piecewise linear models: SIZE equal segments over the turn, the value at 360° is the first again.
#pragma once

#include <Eigen/Core>

#include <span>

namespace straightedge::angle {

/// Values that minimise the sum of squares over the grid (`gridDeg`, i·360/4096): normal equations of the hat
/// functions, a periodic tridiagonal system. The app note fits three copies of the curve side by side and keeps the
/// middle one; the result is the same to rounding.
Eigen::VectorXd linearLeastSquares(const Eigen::VectorXd& gridDeg, int size);

/// Model at i·360/count into out[0 … count).
void evaluateLinear(std::span<const double> valuesDeg, double* out, int count);

double linearAt(std::span<const double> valuesDeg, double readingDeg);

} // namespace straightedge::angle
