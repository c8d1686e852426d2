// The rows of a campaign file, cell by cell. Private to campaign_csv.
#pragma once

#include "core/base/csv_table.h"
#include "core/base/error.h"
#include "core/field/campaign.h"
#include "core/field/campaign_columns.h"

#include <vector>

namespace straightedge::field {

/// Appends the table's rows. Errors (Input, FILE:LINE): those of readCampaignCsv() that lie in a row.
Result<void> addRows(const CsvTable& table, const CampaignLayout& layout, std::vector<CampaignRow>& rows);

} // namespace straightedge::field
