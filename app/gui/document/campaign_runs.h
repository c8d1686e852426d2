// A recorded campaign as the runs of rows that were taken in one go: what Review lists and switches off as one.
#pragma once

#include "core/field/campaign.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace straightedge::gui {

/// Rows [first, first + count) of one step, axis and orientation whose locked reference stays within 10 mT of the row
/// before. Rows that are not locked belong to the run they stand in.
struct CampaignRun {
  field::CampaignStep step = field::CampaignStep::Nonlinearity;
  std::optional<field::Axis> axis;
  std::optional<field::Orientation> orientation;
  std::size_t first = 0;
  std::size_t count = 0;
  std::size_t locked = 0;               ///< rows with a locked reference; all of them in a zero-field chamber
  double referenceT = field::emptyCell; ///< mean of the locked rows; not a number without a reference
};

/// In the order of the rows; every row is in exactly one run.
std::vector<CampaignRun> campaignRuns(const field::Campaign& campaign);

} // namespace straightedge::gui
