// A campaign as Review lists it: stages with their plateaus and sweeps, what counts of each and why the rest does not.
#pragma once

#include "app/gui/document/campaign_runs.h"

#include <QString>

#include <cstddef>
#include <vector>

namespace straightedge::gui {

class FieldDocument;

/// A plateau or a sweep.
struct ListedRun {
  CampaignRun run;
  QString title;      ///< "Plateau 3", "Sweep 1": counted within the stage
  std::size_t on = 0; ///< rows that are not switched off
  QString leftOut;    ///< what of it does not count and why; empty where all of it does
};

/// Runs of one step, axis and orientation.
struct ListedStage {
  field::CampaignStep step = field::CampaignStep::Nonlinearity;
  QString title;
  std::vector<ListedRun> runs;
  std::size_t rows = 0, locked = 0, on = 0;
  bool needsLock = false; ///< rows that are not locked count nowhere
  QString leftOut;
};

/// In the order recorded; empty without a campaign. Rejected plateaus are known once the campaign is fitted.
std::vector<ListedStage> campaignStages(const FieldDocument& document);

} // namespace straightedge::gui
