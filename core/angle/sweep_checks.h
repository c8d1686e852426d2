// What makes a sweep unfit for calibration, and what is worth a warning, each with its sentence.
#pragma once

#include "core/angle/alignment.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace straightedge::angle {

/// Columns of equal length, finite numbers, sensor in [0, 360], encoder within ten thousand turns. Switched-off rows
/// may hold anything.
std::optional<Error> refuseUnreadable(const Sweep& sweep);

/// Fewer than 8 distinct angles, or more than 90° of the circle without an encoder angle (ascending, in [0, 360)).
std::optional<Error> refuseCoverage(const Sweep& sweep, const Eigen::VectorXd& distinctEncoderDeg);

/// Gaps between the readings at the distinct angles (ascending, in [0, 360)): fills medianGapDeg, largestGapDeg and
/// gaps, and refuses a gap of more than 90°.
std::optional<Error> measureGaps(const Sweep& sweep, const Eigen::VectorXd& distinctReadingDeg, AlignedSweep& aligned);

/// Few angles, gaps, a sensor that runs backwards: sentences into aligned.warnings.
void noteWarnings(AlignedSweep& aligned);

} // namespace straightedge::angle
