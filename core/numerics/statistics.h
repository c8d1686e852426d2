// Small statistics of series of numbers.
#pragma once

#include <Eigen/Core>

#include <vector>

namespace straightedge::numerics {

/// √(Σ v²/n); 0 for an empty series.
double rootMeanSquare(const Eigen::VectorXd& values);

/// Largest |v|; 0 for an empty series.
double largestMagnitude(const Eigen::VectorXd& values);

/// Median (mean of the two middle values of an even count); 0 for an empty series. Takes its own copy: it reorders.
double median(std::vector<double> values);

/// Standard deviation pooled over groups: every group adds the squares about its own mean and its count less one.
class PooledDeviation {
public:
  void add(double sumOfSquaresAboutMean, std::size_t count);
  bool isKnown() const { return m_degreesOfFreedom > 0; }
  std::size_t degreesOfFreedom() const { return m_degreesOfFreedom; }
  double variance() const;

private:
  double m_sumOfSquares = 0.0;
  std::size_t m_degreesOfFreedom = 0;
};

} // namespace straightedge::numerics
