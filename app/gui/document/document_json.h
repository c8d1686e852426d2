// What the engineer chose and imported, as the JSON documents that a session keeps beside its samples.
#pragma once

#include "app/gui/document/angle_document.h"

#include <string>
#include <string_view>
#include <vector>

namespace straightedge::gui {

// Document names in a session
inline constexpr const char* choicesDocument = "models";
inline constexpr const char* reviewDocument = "review";
inline constexpr const char* planDocument = "plan";
inline constexpr const char* importedSweepDocument = "imported-sweep";
inline constexpr const char* verificationSweepDocument = "verification-sweep";
inline constexpr const char* resultDocument = "result"; // as calibration.json
inline constexpr const char* verificationResultDocument = "verification-result";

std::string choicesToJson(const AngleChoices& choices);
/// Unknown or malformed parts keep their defaults: an old or newer file still opens. Errors: Input, not JSON at all.
Result<AngleChoices> choicesFromJson(std::string_view json);

/// The rows that are switched off.
std::string reviewToJson(const angle::Sweep& sweep);
Result<std::vector<std::size_t>> reviewFromJson(std::string_view json);

/// Every column and the source, without the switched-off rows (they are the review's).
std::string sweepToJson(const angle::Sweep& sweep);
Result<angle::Sweep> sweepFromJson(std::string_view json);

} // namespace straightedge::gui
