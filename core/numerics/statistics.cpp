#include "core/numerics/statistics.h"

#include <algorithm>
#include <cmath>

namespace straightedge::numerics {

double rootMeanSquare(const Eigen::VectorXd& values) {
  return values.size() == 0 ? 0.0 : std::sqrt(values.squaredNorm() / static_cast<double>(values.size()));
}

double largestMagnitude(const Eigen::VectorXd& values) {
  return values.size() == 0 ? 0.0 : values.cwiseAbs().maxCoeff();
}

double median(std::vector<double> values) {
  if (values.empty()) {
    return 0.0;
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) {
    return *middle;
  }
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

void PooledDeviation::add(double sumOfSquaresAboutMean, std::size_t count) {
  if (count > 1) {
    m_sumOfSquares += sumOfSquaresAboutMean;
    m_degreesOfFreedom += count - 1;
  }
}

double PooledDeviation::variance() const {
  return m_degreesOfFreedom == 0 ? 0.0 : m_sumOfSquares / static_cast<double>(m_degreesOfFreedom);
}

} // namespace straightedge::numerics
