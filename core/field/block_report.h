// What the report of every block of the chain says beside its coefficients.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <string>

namespace straightedge::field {

struct BlockRows {
  std::size_t used = 0;
  std::size_t unlocked = 0;   ///< left out: reference not locked
  std::size_t unsettled = 0;  ///< left out: in rejected plateaus
  std::size_t surplus = 0;    ///< left out: beyond the length of the axis's shortest plateau
  std::size_t incomplete = 0; ///< left out: a value that the step needs is missing
};

/// Of the block's own fit: what its coefficients leave of what they were fitted to, in the block's unit.
struct BlockResiduals {
  double mean = 0.0;
  double sigma = 0.0;   ///< √(Σ residual²/(points − coefficients)); 0 without freedom
  double largest = 0.0; ///< magnitude
  std::size_t points = 0;
  std::size_t coefficients = 0;
};

struct BlockReport {
  std::string how; ///< one sentence: what was fitted to what
  BlockRows rows;
  BlockResiduals residuals;
  Eigen::MatrixXd covariance; ///< of the coefficients in the order the chain holds them, from the fit's own scatter
};

} // namespace straightedge::field
