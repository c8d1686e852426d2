#include "core/field/probe_lag.h"

#include <Eigen/LU>
#include <Eigen/QR>

#include <cmath>
#include <numbers>

namespace straightedge::field {

namespace {

/// A line has to fit this much better with the lag than without before the lag is believed.
constexpr double clearlyBetter = 0.9;

/// A first-order lag of a temperature that is a straight line between its samples: exact from sample to sample.
Eigen::VectorXd lagged(const Eigen::VectorXd& timeS, const Eigen::VectorXd& chamberC, double lagS) {
  Eigen::VectorXd result(chamberC.size());
  result[0] = chamberC[0];
  for (Eigen::Index i = 1; i < chamberC.size(); ++i) {
    const double step = timeS[i] - timeS[i - 1];
    if (step <= 0.0) {
      result[i] = result[i - 1];
      continue;
    }
    const double rate = (chamberC[i] - chamberC[i - 1]) / step;
    result[i] = chamberC[i] - lagS * rate + (result[i - 1] - chamberC[i - 1] + lagS * rate) * std::exp(-step / lagS);
  }
  return result;
}

struct Attempt {
  LagFit fit;
  double sum = 0.0;   ///< of squared residuals
  double start = 0.0; ///< how far the probe was out of balance at the first row, °C
};

/// Regressors: 1, resistance about its mean, and what is left of a start out of balance.
Attempt attempt(const Eigen::VectorXd& timeS, const Eigen::VectorXd& chamberC, const Eigen::VectorXd& ohm,
                double lagS) {
  Attempt result;
  result.fit.lagS = lagS;
  const double middle = ohm.mean();
  const bool withLag = lagS > 0.0;
  Eigen::MatrixXd columns(ohm.size(), withLag ? 3 : 2);
  columns.col(0).setOnes();
  columns.col(1) = ohm.array() - middle;
  Eigen::VectorXd felt = chamberC;
  if (withLag) {
    felt = lagged(timeS, chamberC, lagS);
    columns.col(2) = (-(timeS.array() - timeS[0]) / lagS).exp();
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(columns);
  const Eigen::VectorXd solution = qr.solve(felt);
  result.fit.residuals = felt - columns * solution;
  result.sum = result.fit.residuals.squaredNorm();
  result.fit.slope = solution[1];
  result.fit.intercept = solution[0] - solution[1] * middle;
  result.fit.laggedC = withLag ? Eigen::VectorXd(felt - solution[2] * columns.col(2)) : felt;
  result.start = withLag ? solution[2] : 0.0;
  return result;
}

/// Of intercept and slope with the lag free, by the fit's derivatives: a lag that is a little longer goes with a PT100
/// that is a little steeper, more so the faster the chamber was swept.
Eigen::Matrix2d covarianceOf(const Attempt& found, const Eigen::VectorXd& timeS, const Eigen::VectorXd& chamberC,
                             const Eigen::VectorXd& ohm) {
  const double lagS = found.fit.lagS;
  const double middle = ohm.mean();
  const auto decay = [&timeS](double lag) { return Eigen::VectorXd((-(timeS.array() - timeS[0]) / lag).exp()); };
  const auto balanced = [&](double lag) {
    return Eigen::VectorXd(lagged(timeS, chamberC, lag) - found.start * decay(lag));
  };
  constexpr double step = 1e-4;
  Eigen::MatrixXd columns(ohm.size(), 4);
  columns.col(0).setOnes();
  columns.col(1) = ohm.array() - middle;
  columns.col(2) = decay(lagS);
  columns.col(3) = (balanced(lagS * (1.0 + step)) - balanced(lagS * (1.0 - step))) / (2.0 * step * lagS);
  const auto freedom = static_cast<double>(ohm.size() - columns.cols());
  const Eigen::MatrixXd spread = (columns.transpose() * columns).inverse() * (found.sum / freedom);
  Eigen::Matrix2d shift; // to resistance from zero
  shift << 1.0, -middle, 0.0, 1.0;
  return shift * spread.topLeftCorner(2, 2) * shift.transpose();
}

} // namespace

std::optional<LagFit> fitLag(const Eigen::VectorXd& timeS, const Eigen::VectorXd& chamberC,
                             const Eigen::VectorXd& ohm) {
  constexpr Eigen::Index leastTimedRows = 10;
  constexpr int gridSteps = 24;
  constexpr int refinements = 30;
  const Eigen::Index rows = timeS.size();
  const double duration = rows > 1 ? timeS[rows - 1] - timeS[0] : 0.0;
  if (rows < leastTimedRows || !(duration > 0.0)) {
    return std::nullopt;
  }
  const auto sumAt = [&](double logLag) { return attempt(timeS, chamberC, ohm, std::exp(logLag)).sum; };
  const double least = std::log(0.2 * duration / static_cast<double>(rows - 1));
  const double most = std::log(0.25 * duration);
  const double step = (most - least) / gridSteps;
  double best = least;
  double bestSum = sumAt(least);
  for (int i = 1; i <= gridSteps; ++i) {
    const double here = least + step * i;
    if (const double sum = sumAt(here); sum < bestSum) {
      best = here;
      bestSum = sum;
    }
  }
  // Golden section between the neighbours of the best grid point.
  constexpr double golden = 1.0 / std::numbers::phi;
  double from = best - step;
  double to = best + step;
  double left = to - golden * (to - from);
  double right = from + golden * (to - from);
  double leftSum = sumAt(left);
  double rightSum = sumAt(right);
  for (int i = 0; i < refinements; ++i) {
    if (leftSum < rightSum) {
      to = right;
      right = left;
      rightSum = leftSum;
      left = to - golden * (to - from);
      leftSum = sumAt(left);
    } else {
      from = left;
      left = right;
      leftSum = rightSum;
      right = from + golden * (to - from);
      rightSum = sumAt(right);
    }
  }
  Attempt found = attempt(timeS, chamberC, ohm, std::exp((from + to) / 2.0));
  const Attempt without = attempt(timeS, chamberC, ohm, 0.0);
  if (!(found.sum < clearlyBetter * clearlyBetter * without.sum)) {
    return std::nullopt;
  }
  found.fit.covariance = covarianceOf(found, timeS, chamberC, ohm);
  return std::move(found.fit);
}

} // namespace straightedge::field
