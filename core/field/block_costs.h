// What a calibration lacks when a block is off, in sentences. Private to the fit.
#pragma once

#include "core/field/calibration.h"

#include <string>

namespace straightedge::field {

/// The step that the block is fitted to.
CampaignStep stepOf(Block block);

/// "Block sensitivity of axis y is off: REASON. COST" `reason` without a full stop.
FieldWarning switchedOff(Block block, const std::optional<Axis>& axis, const std::string& reason);

} // namespace straightedge::field
