// A campaign for the commands that take one: from a CSV file, or out of a session.
#pragma once

#include "core/base/error.h"
#include "core/base/traceability.h"
#include "core/field/campaign.h"

#include <string>

namespace straightedge::cli {

struct LoadedCampaign {
  field::Campaign campaign;
  Traceability traceability; ///< what a session knows of device, operator and reference
};

/// `path` is a CSV file, "-" for standard input, or a session file, recognised by its content. Errors: those of
/// readCampaignCsv() and readSessionCampaign().
Result<LoadedCampaign> loadCampaign(const std::string& path);

} // namespace straightedge::cli
