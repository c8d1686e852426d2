// A campaign as recorded, step by step.
#pragma once

#include "app/gui/figures/sweep_figures.h"
#include "core/field/campaign.h"

#include <vector>

namespace straightedge::gui {

/// The rows of one step in the order they were recorded: raw readings of the axes (of a step with an axis, only that
/// one), of the probe's temperature chamber and resistance. Rows that are not locked are left out where the step needs
/// the reference; rows of `enabled` that are false (switched off) are emphasised. `enabled` may be empty: all on.
RowFigure campaignStepFigure(const field::Campaign& campaign, field::CampaignStep step,
                             const std::vector<bool>& enabled = {});

} // namespace straightedge::gui
