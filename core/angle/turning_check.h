// Does the sensor turn exactly once while the encoder does, and which way round?
#pragma once

#include "core/angle/alignment.h"

#include <Eigen/Core>

#include <optional>

namespace straightedge::angle {

/// Judged from neighbours on the encoder's circle alone, so that the rows' order does not matter. Refuses a constant
/// sensor; readings that differ from neighbour to neighbour without a rule; a whole number of turns other than one; a
/// single jump that undoes a steady drift (a sensor of, say, 0.9 turns). On success `direction` is set.
/// `encoderDeg` and `sensorDeg` in [0, 360), any order, at least 3 different encoder angles.
std::optional<Error> refuseTurning(const Sweep& sweep, const Eigen::VectorXd& encoderDeg,
                                   const Eigen::VectorXd& sensorDeg, SensorDirection& direction);

/// A sensor that gains or loses more than 2° against the encoder with every turn, from neighbours that were recorded in
/// different turns.
std::optional<Error> refuseDrift(const Sweep& sweep, const AlignedSweep& aligned);

} // namespace straightedge::angle
