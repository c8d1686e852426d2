// Piecewise linear model with the smallest possible maximum error on the grid: a true optimum, with its proof.
#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"

#include <Eigen/Core>

#include <vector>

namespace straightedge::angle {

/// Weights w on grid samples that prove how small a maximum error can be at all. With hat functions φk of the nodes:
///   Σ|w| = 1 and Σ w·φk = 0 for every node k.
/// For any node values y then Σ w·c = Σ w·(c − Σ yk·φk) ≤ max|c − model|, so Σ w·c is a lower bound for every model of
/// this size. Where it equals the error of a model, that model is optimal: whoever doubts the solver need only add up.
struct MinimaxProof {
  struct Weight {
    int sample = 0; ///< grid index
    double value = 0.0;
  };
  std::vector<Weight> weights; ///< ascending samples, at most a few per segment
  double lowerBoundDeg = 0.0;  ///< Σ w·c
};

struct MinimaxLinear {
  Eigen::VectorXd valuesDeg; ///< node values, the one at 0° first; where the optimum leaves room, near least squares
  double maxErrorDeg = 0.0;  ///< on the grid
  MinimaxProof proof;        ///< its lower bound meets maxErrorDeg to rounding (1e-9 of the curve's swing)
};

/// Smallest maximum error of `size` segments over the curve at i·360/4096 (`gridDeg`, any length of at least
/// 2·size works). Milliseconds; thread-safe. Errors: Cancelled.
///
/// Method: with the value at node 0 and an error bound given, the values possible at each next node are an interval,
/// and a whole turn of such steps ends in an interval that must hold the first value again. Where it does not, the
/// samples responsible give a linear inequality between error bound and first value (minimax_chain.h). The least bound
/// that all inequalities found so far allow is tried next, until one is feasible: that one is least, and the
/// inequalities that hold it up are the proof. (Kelley's cutting planes, in two unknowns.)
Result<MinimaxLinear> linearMinimax(const Eigen::VectorXd& gridDeg, int size, const JobControl& job = {});

} // namespace straightedge::angle
