// Trigonometric polynomials on a circle of 360 degrees, fitted by least squares to unevenly spaced points.
//
// f(x) = offset + Σ cosine[k−1]·cos(k·x) + sine[k−1]·sin(k·x), k = 1 … harmonics
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace straightedge::numerics {

double trigonometricAt(double offset, const Eigen::VectorXd& cosine, const Eigen::VectorXd& sine, double deg);

/// Values at i·360/count, i = 0 … count−1.
Eigen::VectorXd trigonometricSampled(double offset, const Eigen::VectorXd& cosine, const Eigen::VectorXd& sine,
                                     int count);

struct TrigonometricFit {
  double offset = 0.0;
  Eigen::VectorXd cosine, sine;
  int harmonics = 0;
  Eigen::VectorXd residuals;        ///< value − f at every point
  Eigen::VectorXd leftOutResiduals; ///< the same with the point's whole group left out of the fit
  std::vector<double> leftOutRms;   ///< rms of those for 0, 1, 2, … harmonics: what the choice was made from
  double residualSigma = 0.0;       ///< √(Σ residual²/(points − coefficients)); 0 without freedom
  Eigen::Index coefficients() const { return 2 * cosine.size() + 1; }
};

/// Fits every number of harmonics from 0 to `maxHarmonics` at once (one Cholesky factor holds them all, nested) and
/// keeps the number with the least rms of left-out residuals; of equally good ones the smallest.
/// `group`: one index per point, 0 … groups−1; points of a group are left out together, so that repeats of an angle do
/// not foretell each other. Exact where the points of a group share one x, else to the order of their spread times the
/// highest harmonic. Stops early at a number of harmonics that the points no longer determine.
/// The sums need O(points·maxHarmonics), the choice O(groups·maxHarmonics²).
TrigonometricFit fitTrigonometric(const Eigen::VectorXd& deg, const Eigen::VectorXd& values,
                                  const std::vector<std::size_t>& group, std::size_t groups, int maxHarmonics);

} // namespace straightedge::numerics
