// Figures of a block's residuals. Private to the blocks.
#pragma once

#include "core/field/block_report.h"
#include "core/field/step_rows.h"

#include <Eigen/Core>

#include <cmath>

namespace straightedge::field {

inline BlockResiduals residualsOf(const Eigen::VectorXd& residuals, Eigen::Index coefficients) {
  BlockResiduals result;
  result.points = static_cast<std::size_t>(residuals.size());
  result.coefficients = static_cast<std::size_t>(coefficients);
  if (residuals.size() == 0) {
    return result;
  }
  result.mean = residuals.mean();
  result.largest = residuals.cwiseAbs().maxCoeff();
  const Eigen::Index freedom = residuals.size() - coefficients;
  result.sigma = freedom > 0 ? std::sqrt(residuals.squaredNorm() / static_cast<double>(freedom)) : 0.0;
  return result;
}

/// Rows of a step that a block takes as they are.
inline BlockRows rowsOf(const StepRows& rows) {
  BlockRows result;
  result.used = static_cast<std::size_t>(rows.size());
  result.unlocked = rows.unlocked;
  result.incomplete = rows.incomplete;
  return result;
}

} // namespace straightedge::field
