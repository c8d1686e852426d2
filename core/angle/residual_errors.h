// Largest and root-mean-square difference of two sampled curves.
#pragma once

#include <cstddef>

namespace straightedge::angle {

struct ResidualErrors {
  double maxAbs = 0.0;
  double rms = 0.0;
};

/// Over `count` samples of each. The order of summation is fixed (eight running sums), so that the result does not
/// depend on the width of the machine's vectors.
ResidualErrors residualErrors(const double* left, const double* right, std::size_t count);

} // namespace straightedge::angle
