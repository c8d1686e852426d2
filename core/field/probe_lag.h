// How far a probe trails the chamber that it is warmed in. Private to probe_temperature.
#pragma once

#include <Eigen/Core>

#include <optional>

namespace straightedge::field {

struct LagFit {
  double lagS = 0.0;                                    ///< time constant of a first-order lag
  double slope = 0.0;                                   ///< of the lagged chamber temperature over resistance, °C/Ω
  double intercept = 0.0;                               ///< °C
  Eigen::VectorXd laggedC;                              ///< chamber temperature as the probe felt it
  Eigen::VectorXd residuals;                            ///< laggedC − line
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero(); ///< of intercept and slope; the lag is not exactly known either
};

/// The time constant that leaves the least residual of a line through (lagged chamber temperature, resistance); the
/// probe's state at the start is free. `timeS` rises. Nothing where no lag does clearly better than none.
std::optional<LagFit> fitLag(const Eigen::VectorXd& timeS, const Eigen::VectorXd& chamberC, const Eigen::VectorXd& ohm);

} // namespace straightedge::field
