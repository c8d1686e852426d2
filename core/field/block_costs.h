// What a calibration lacks when a block is off, in sentences.
#pragma once

#include "core/field/calibration.h"

#include <string>

namespace straightedge::field {

/// The step that the block is fitted to.
CampaignStep stepOf(Block block);

/// One or two whole sentences: what stays in the reading without the block.
const char* costOf(Block block);

/// "Block sensitivity of axis y is off: REASON. COST" `reason` without a full stop.
FieldWarning switchedOff(Block block, const std::optional<Axis>& axis, const std::string& reason);

} // namespace straightedge::field
