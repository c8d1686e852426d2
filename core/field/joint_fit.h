// All blocks of the chain refined together by nonlinear least squares, as an alternative to one block after the other:
// a block's fit then knows what the others can take over, and every row of the campaign counts for every block.
//
// Per axis: minimise Σ w·(V5(raw, T, E) − target)² over the axis's coefficients and its row of S, by Levenberg and
// Marquardt's method (Marquardt 1963, J. Soc. Indust. Appl. Math. 11, 431) with analytic derivatives and a QR
// decomposition of the scaled Jacobian. The target is the reference field; 0 in a zero-field chamber; the axis's row of
// S times the field against the package in the orientations. So the axes are independent of each other. Which
// coefficients are unknown: axis_parameters.h. Where even errors are asked for, S is taken from the closest fit
// (closest_fit.h) and held: what the polynomials cannot follow at the few fields of the orientations would pass for a
// gain.
#pragma once

#include "core/base/error.h"
#include "core/field/axis_parameters.h"
#include "core/field/calibration.h"
#include "core/field/fit_points.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace straightedge::field {

/// How much each point counts.
enum class JointWeights : std::uint8_t {
  /// For a small largest error. What is left is mostly what the polynomials cannot follow, and not noise; so a setting
  /// of the field counts once, however many rows and temperatures were recorded at it, and plateaus count by
  /// 1/√(1 − (field/largest field)²), the density of Chebyshev's points, with which least squares come close to the
  /// smallest possible maximum (Trefethen, Approximation Theory and Approximation Practice, chapters 4 and 10).
  EvenError,
  /// By the inverse of the variance that the rows' own scatter gives a point: right where the chain can follow the
  /// instrument, and what the uncertainty is worked out with.
  Noise,
};

struct JointOptions {
  JointWeights weights = JointWeights::EvenError;
  bool holdAxisMatrix = false; ///< S is no unknown
  int mostIterations = 30;
};

/// One axis. Outcomes are fields, not errors.
struct JointAxisReport {
  std::vector<ChainParameter> parameters; ///< the unknowns; then the three of the row of S, if there are orientations
  bool fitsAxisRow = false;
  Eigen::VectorXd values;
  /// Of the unknowns, from the rows' scatter alone, propagated through the weights: what a repeated campaign would
  /// scatter by, not what the polynomials cannot follow.
  Eigen::MatrixXd covariance;
  double noiseT = 0.0;        ///< of a single row at zero field, in V5
  double noisePerTesla = 0.0; ///< σ² = noiseT² + (noisePerTesla·field)²
  int iterations = 0;
  bool converged = false;
  double costBefore = 0.0; ///< √(Σ w·residual²/Σ w), tesla; before is the chain given
  double costAfter = 0.0;
  double peakBeforeT = 0.0; ///< largest |residual| of a point
  double peakAfterT = 0.0;
  double excess = 1.0; ///< √(Σ (residual/its noise)²/freedom): above 1 where the polynomials cannot follow
  double restT = 0.0;  ///< standard deviation of what is left beyond noise; 0 where noise explains it (three sigma)
  std::size_t points = 0;
  std::size_t rows = 0;
};

struct JointReport {
  CorrectionChain chain;
  std::array<JointAxisReport, 3> axes;
  std::string how; ///< one sentence for a report
  bool converged() const { return axes[0].converged && axes[1].converged && axes[2].converged; }
};

/// `start`: the chain fitted step by step; blocks that are off in it stay off.
/// Errors (Input): the nonlinearity of an axis is off; an axis has fewer points than unknowns, or points that do not
/// determine them.
Result<JointReport> fitJointly(const CampaignParts& parts, const CorrectionChain& start, const JointOptions& options,
                               const std::string& name);
/// The same where the points are there already, in one go with the start's S.
Result<JointReport> fitJointly(const FitPoints& points, const CorrectionChain& start, const JointOptions& options,
                               const std::string& name);

} // namespace straightedge::field
