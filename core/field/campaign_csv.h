// Campaigns from and to CSV files: the recorded rows as they are, nothing judged but whether they are complete.
#pragma once

#include "core/base/error.h"
#include "core/field/campaign.h"

#include <string>

namespace straightedge::field {

/// Reads a campaign. The header names the columns, in any order and case; `step` and the three raw readings must be
/// there, of the others those that the file's steps need (shared with needsOf()); further columns are passed over.
/// Without a column reference_locked a row is locked where it has a reference. `time_s` is optional.
/// `path` or "-". Errors (Input): those of CsvTable; no header, a column that is missing or there twice; FILE:LINE for
/// an unknown step, axis or orientation, text that is no finite number, a value that the row's step needs and that is
/// empty, a field beyond 100 T (another unit), a resistance that is not positive.
Result<Campaign> readCampaignCsv(const std::string& path);

/// The same from bytes already read; `name` for messages, `fileName` for Campaign::name.
Result<Campaign> parseCampaignCsv(std::string bytes, const std::string& name, const std::string& fileName);

/// Canonical CSV with the columns of readCampaignCsv(), time_s where a row has one. Numbers read back to the same
/// doubles; empty cells stay empty.
std::string campaignCsv(const Campaign& campaign);

} // namespace straightedge::field
