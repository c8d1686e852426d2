#include "app/cli/campaign_input.h"

#include "core/angle/session_sweep.h"
#include "core/field/campaign_csv.h"
#include "core/field/session_campaign.h"

#include <utility>

namespace straightedge::cli {

Result<LoadedCampaign> loadCampaign(const std::string& path) {
  if (angle::isSessionFile(path)) {
    auto stored = field::readSessionCampaign(path, session::SweepRole::Calibration);
    if (!stored) {
      return std::unexpected(std::move(stored.error()));
    }
    return LoadedCampaign{std::move(stored->campaign), std::move(stored->traceability)};
  }
  auto campaign = field::readCampaignCsv(path);
  if (!campaign) {
    return std::unexpected(std::move(campaign.error()));
  }
  return LoadedCampaign{*std::move(campaign), {}};
}

} // namespace straightedge::cli
