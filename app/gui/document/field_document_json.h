// What the engineer chose and imported for a field calibration, as the JSON documents that a session keeps.
#pragma once

#include "app/gui/document/field_choices.h"
#include "core/base/error.h"
#include "core/field/campaign.h"

#include <string>
#include <string_view>
#include <vector>

namespace straightedge::gui {

// Document names in a session, beside those that both kinds have (document_json.h)
inline constexpr const char* fieldChoicesDocument = "choices";
inline constexpr const char* importedCampaignDocument = "imported-campaign";
inline constexpr const char* verificationCampaignDocument = "verification-campaign";

std::string fieldChoicesToJson(const FieldChoices& choices);
/// Unknown or malformed parts keep their defaults: an old or newer file still opens. Errors: Storage, not JSON at all.
Result<FieldChoices> fieldChoicesFromJson(std::string_view json);

/// The rows that are switched off; reviewFromJson() reads it.
std::string switchedOffToJson(const std::vector<bool>& enabled);

/// Name, hash and lines of the file it came from, and the rows as canonical CSV.
std::string campaignToJson(const field::Campaign& campaign);
Result<field::Campaign> campaignFromJson(std::string_view json);

} // namespace straightedge::gui
