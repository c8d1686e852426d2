// Raw samples of a session -> the campaign that is calibrated or verified.
#pragma once

#include "core/base/error.h"
#include "core/base/traceability.h"
#include "core/field/campaign.h"
#include "core/session/session.h"

#include <string>
#include <vector>

namespace straightedge::field {

/// One row per sample, in the plan's order of stages, then of arrival; of a stage that was measured again only the
/// latest attempt. Lines count from 2, as in the CSV file that campaignCsv() makes of it. `name` is for messages and
/// becomes Campaign::name.
/// Errors (Storage): a number that is no step, axis or orientation.
Result<Campaign> campaignFromSamples(const std::vector<session::FieldSample>& samples, const std::string& name);

/// A campaign's row as a sample; its sequence, stage, point and attempt are left for the caller.
session::FieldSample sampleFromRow(const CampaignRow& row);

struct SessionCampaign {
  Campaign campaign; ///< name: the file's; sha256: of its canonical CSV
  Traceability traceability;
};

/// Reads a campaign out of a session file, which is not changed. Errors: those of Session::openReadOnly; Input, where
/// the session is of another kind or holds no captured campaign of that role.
Result<SessionCampaign> readSessionCampaign(const std::string& path, session::SweepRole role);

} // namespace straightedge::field
