// Readings of an angle sensor: every row gets the column corrected_deg.
#pragma once

#include "app/cli/block_correction.h"
#include "core/angle/model.h"

namespace straightedge::cli {

/// Errors when it meets the readings: those of findAngleReadings(). A row's errors: no number, outside 0 to 360°.
MakeCorrection angleCorrection(const angle::Model& model, angle::SensorDirection direction);

} // namespace straightedge::cli
