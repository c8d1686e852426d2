#include "core/angle/residual_errors.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace straightedge::angle {

ResidualErrors residualErrors(const double* left, const double* right, std::size_t count) {
  using Lanes = Eigen::Array<double, 8, 1>;
  Lanes sum = Lanes::Zero();
  Lanes largest = Lanes::Zero();
  std::size_t i = 0;
  for (; i + 8 <= count; i += 8) {
    const Lanes difference = Eigen::Map<const Lanes>(left + i) - Eigen::Map<const Lanes>(right + i);
    sum += difference * difference;
    largest = largest.max(difference.abs());
  }
  double total = sum.sum();
  double maxAbs = largest.maxCoeff();
  for (; i < count; ++i) {
    const double difference = left[i] - right[i];
    total += difference * difference;
    maxAbs = std::max(maxAbs, std::abs(difference));
  }
  return {maxAbs, count == 0 ? 0.0 : std::sqrt(total / static_cast<double>(count))};
}

} // namespace straightedge::angle
