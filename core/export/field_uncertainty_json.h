// The key "uncertainty" of a field calibration.json.
#pragma once

#include "core/base/json_writer.h"
#include "core/export/json_reader.h"
#include "core/field/uncertainty_summary.h"

#include <optional>

namespace straightedge::exporting {

/// Tesla and °C by the keys' endings; nothing is written where there is none.
void writeFieldUncertainty(JsonWriter& json, const std::optional<field::UncertaintySummary>& uncertainty);

/// Nothing where the key is absent; what is wrong stays in the reader.
std::optional<field::UncertaintySummary> readFieldUncertainty(JsonReader& reader, const JsonNode& root);

} // namespace straightedge::exporting
