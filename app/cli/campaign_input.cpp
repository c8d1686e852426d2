#include "app/cli/campaign_input.h"

#include "core/angle/session_sweep.h"
#include "core/base/file_bytes.h"
#include "core/field/campaign_csv.h"

#include <utility>

namespace straightedge::cli {

Result<LoadedCampaign> loadCampaign(const std::string& path) {
  if (angle::isSessionFile(path)) {
    return fail(ErrorKind::Input, "sessions of a teslameter cannot be read here in this version",
                "name the campaign as a CSV file", inputName(path));
  }
  auto campaign = field::readCampaignCsv(path);
  if (!campaign) {
    return std::unexpected(std::move(campaign.error()));
  }
  return LoadedCampaign{*std::move(campaign), {}};
}

} // namespace straightedge::cli
