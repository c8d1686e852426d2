// Piecewise linear model with the smallest possible maximum error on the grid.
#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"

#include <Eigen/Core>

namespace straightedge::angle {

struct MinimaxLinear {
  Eigen::VectorXd valuesDeg; ///< node values, the one at 0° first
  double maxErrorDeg = 0.0;
};

/// Errors: Cancelled.
Result<MinimaxLinear> linearMinimax(const Eigen::VectorXd& gridDeg, int size, const JobControl& job = {});

} // namespace straightedge::angle
