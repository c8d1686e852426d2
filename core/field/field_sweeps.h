// Temperature sweeps at locked fields, each as a line of the error over temperature. Private to sensitivity.
#pragma once

#include "core/field/sensitivity.h"

namespace straightedge::field {

/// What is swept, and what its errors are taken from.
struct SweepInputs {
  const StepRows& rows;
  Eigen::VectorXd valueT;       ///< of the axis before the block
  Eigen::VectorXd temperatureC; ///< minus the reference temperature
  std::string thing;            ///< "probe" or "electronics", for messages
};

/// A sweep per run; runs that are too short or whose temperature does not move are left out.
/// Errors (Input): those of fitSensitivity.
Result<std::vector<FieldSweep>> sweepsOf(const SweepInputs& inputs, const std::string& name);

/// Fields that differ by more than plateauToleranceT.
int distinctFields(const std::vector<FieldSweep>& sweeps);

/// Fills meanErrorAfterT and gives the residuals of all rows that belong to a sweep. `afterT`: the axis after the
/// block.
Eigen::VectorXd errorsAfter(const SweepInputs& inputs, const Eigen::VectorXd& afterT, std::vector<FieldSweep>& sweeps);

Eigen::VectorXd valuesOf(const std::vector<FieldSweep>& sweeps, double FieldSweep::* member);

} // namespace straightedge::field
