#include "core/angle/linear_model.h"

#include "core/angle/bin_walk.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <vector>

namespace straightedge::angle {

namespace {

/// Normal equations: diagonal[k]·y[k] + beside[k−1]·y[k−1] + beside[k]·y[k+1] = right[k], indices modulo the size.
struct PeriodicSystem {
  std::vector<double> diagonal, beside, right;
};

struct SegmentSums {
  double value = 0.0;  ///< Σ c
  double moment = 0.0; ///< Σ j·c, j counted from the segment's first sample
};

/// `ramp` holds 0, 1, 2, …; short segments are not worth a vector loop's start.
SegmentSums sumsOf(const double* segment, int samples, const Eigen::VectorXd& ramp) {
  if (samples >= 16) {
    const Eigen::Map<const Eigen::VectorXd> values(segment, samples);
    return {values.sum(), values.dot(ramp.head(samples))};
  }
  SegmentSums sums;
  for (int j = 0; j < samples; ++j) {
    sums.value += segment[j];
    sums.moment += j * segment[j];
  }
  return sums;
}

PeriodicSystem normalEquations(const double* curve, int count, int size) {
  const auto n = static_cast<std::size_t>(size);
  PeriodicSystem system{std::vector<double>(n), std::vector<double>(n), std::vector<double>(n)};
  const double scale = 1.0 / count;
  const int longest = count / size + 1;
  const Eigen::VectorXd ramp = Eigen::VectorXd::LinSpaced(longest, 0.0, longest - 1.0);
  BinWalk segment(size, count);
  for (std::size_t here = 0; here < n; ++here, segment.next()) {
    // t = (u0 + j·size)/count is how far sample first + j lies into the segment; its sums are exact in integers.
    const long long samples = segment.samples();
    const long long u0 = segment.into();
    const long long sumJ = samples * (samples - 1) / 2;
    const long long sumJJ = (samples - 1) * samples * (2 * samples - 1) / 6;
    const long long sumU = samples * u0 + size * sumJ;
    const long long sumUU = samples * u0 * u0 + 2 * u0 * size * sumJ + static_cast<long long>(size) * size * sumJJ;
    const double sumT = static_cast<double>(sumU) * scale;
    const double sumTT = static_cast<double>(sumUU) * scale * scale;
    const SegmentSums sums = sumsOf(curve + segment.first(), segment.samples(), ramp);
    const double sumTC = (static_cast<double>(u0) * sums.value + size * sums.moment) * scale;
    const std::size_t next = here + 1 == n ? 0 : here + 1;
    system.diagonal[here] += static_cast<double>(samples) - 2.0 * sumT + sumTT;
    system.diagonal[next] += sumTT;
    system.beside[here] = sumT - sumTT;
    system.right[here] += sums.value - sumTC;
    system.right[next] += sumTC;
  }
  return system;
}

/// Sherman and Morrison: the two corner entries are a rank-one change of a tridiagonal matrix. No pivoting is needed:
/// the matrix of hat functions is diagonally dominant.
Eigen::VectorXd solvePeriodic(PeriodicSystem& system) {
  const std::size_t n = system.diagonal.size();
  Eigen::VectorXd solution(static_cast<Eigen::Index>(n));
  if (n == 2) { // both neighbours are the same node
    const double a = system.diagonal[0];
    const double b = system.beside[0] + system.beside[1];
    const double d = system.diagonal[1];
    const double determinant = a * d - b * b;
    solution[0] = (system.right[0] * d - system.right[1] * b) / determinant;
    solution[1] = (system.right[1] * a - system.right[0] * b) / determinant;
    return solution;
  }
  const double corner = system.beside[n - 1];
  const double gamma = -system.diagonal[0];
  std::vector<double>& diagonal = system.diagonal;
  std::vector<double>& right = system.right;
  std::vector<double> change(n, 0.0); // right side of the second system
  change[0] = gamma;
  change[n - 1] = corner;
  diagonal[n - 1] -= corner * corner / gamma;
  diagonal[0] -= gamma;
  diagonal[0] = 1.0 / diagonal[0]; // from here on the reciprocals
  for (std::size_t k = 1; k < n; ++k) {
    const double factor = system.beside[k - 1] * diagonal[k - 1];
    diagonal[k] = 1.0 / (diagonal[k] - factor * system.beside[k - 1]);
    right[k] -= factor * right[k - 1];
    change[k] -= factor * change[k - 1];
  }
  right[n - 1] *= diagonal[n - 1];
  change[n - 1] *= diagonal[n - 1];
  for (std::size_t k = n - 1; k-- > 0;) {
    right[k] = (right[k] - system.beside[k] * right[k + 1]) * diagonal[k];
    change[k] = (change[k] - system.beside[k] * change[k + 1]) * diagonal[k];
  }
  const double ratio = corner / gamma;
  const double factor = (right[0] + ratio * right[n - 1]) / (1.0 + change[0] + ratio * change[n - 1]);
  for (std::size_t k = 0; k < n; ++k) {
    solution[static_cast<Eigen::Index>(k)] = right[k] - factor * change[k];
  }
  return solution;
}

} // namespace

Eigen::VectorXd linearLeastSquares(const Eigen::VectorXd& gridDeg, int size) {
  assert(size >= 2 && gridDeg.size() >= 2 * size);
  PeriodicSystem system = normalEquations(gridDeg.data(), static_cast<int>(gridDeg.size()), size);
  return solvePeriodic(system);
}

void evaluateLinear(std::span<const double> valuesDeg, double* out, int count) {
  const int size = static_cast<int>(valuesDeg.size());
  const double scale = 1.0 / count;
  BinWalk segment(size, count);
  for (std::size_t k = 0; k < valuesDeg.size(); ++k, segment.next()) {
    const double rise = valuesDeg[k + 1 == valuesDeg.size() ? 0 : k + 1] - valuesDeg[k];
    const double start = valuesDeg[k] + rise * (segment.into() * scale);
    const double slope = rise * (size * scale);
    double* const target = out + segment.first();
    for (int j = 0; j < segment.samples(); ++j) {
      target[j] = start + slope * j;
    }
  }
}

double linearAt(std::span<const double> valuesDeg, double readingDeg) {
  const std::size_t size = valuesDeg.size();
  const double position = readingDeg * static_cast<double>(size) / 360.0;
  // Should the quotient just below 360° round up to the size: the end of the last segment is the same point.
  const std::size_t k = std::min(static_cast<std::size_t>(position), size - 1);
  const double value = valuesDeg[k];
  const double next = valuesDeg[k + 1 == size ? 0 : k + 1];
  return value + (next - value) * (position - static_cast<double>(k));
}

} // namespace straightedge::angle
