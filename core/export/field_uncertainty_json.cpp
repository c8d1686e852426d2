#include "core/export/field_uncertainty_json.h"

#include "core/export/json_optional.h"
#include "core/field/names.h"

namespace straightedge::exporting {

using field::UncertaintySummary;

void writeFieldUncertainty(JsonWriter& json, const std::optional<UncertaintySummary>& uncertainty) {
  if (!uncertainty) {
    return;
  }
  json.openObject("uncertainty");
  json.member("probability", uncertainty->probability);
  json.member("of", "each component of one corrected reading");
  json.member("expanded_largest_T", uncertainty->largestT);
  json.member("expanded_median_T", uncertainty->medianT);
  json.member("reference_relative", uncertainty->referenceRelative);
  json.openList("contributions");
  for (const field::UncertaintyShare& share : uncertainty->shares) {
    json.beginObject(true);
    json.member("name", share.name);
    json.member("largest_standard_T", share.largestT);
    json.member("basis", share.basis);
    json.endObject();
  }
  json.endList();
  json.openList("grid");
  for (const field::UncertaintyAt& at : uncertainty->grid) {
    json.beginObject(true);
    json.member("axis", field::axisName(field::allAxes[static_cast<std::size_t>(at.axis)]));
    json.member("field_T", at.fieldT);
    json.member("probe_C", at.probeC);
    json.member("electronics_C", at.electronicsC);
    json.member("expanded_T", at.expandedT);
    json.endObject();
  }
  json.endList();
  json.endObject();
}

std::optional<UncertaintySummary> readFieldUncertainty(JsonReader& reader, const JsonNode& root) {
  const JsonNode node = root.optional("uncertainty");
  if (!node || !reader.requireObject(node)) {
    return std::nullopt;
  }
  UncertaintySummary summary;
  summary.probability = numberIfAny(reader, node, "probability", summary.probability);
  summary.largestT = numberIfAny(reader, node, "expanded_largest_T");
  summary.medianT = numberIfAny(reader, node, "expanded_median_T");
  summary.referenceRelative = numberIfAny(reader, node, "reference_relative");
  const JsonNode shares = listIfAny(reader, node, "contributions");
  for (std::size_t i = 0; i < shares.size() && !reader.problem(); ++i) {
    if (const JsonNode share = shares.item(i); reader.requireObject(share)) {
      summary.shares.push_back({textIfAny(reader, share, "name"), numberIfAny(reader, share, "largest_standard_T"),
                                textIfAny(reader, share, "basis")});
    }
  }
  const JsonNode grid = listIfAny(reader, node, "grid");
  for (std::size_t i = 0; i < grid.size() && !reader.problem(); ++i) {
    const JsonNode point = grid.item(i);
    if (!reader.requireObject(point)) {
      break;
    }
    const auto axis = field::parseAxis(textIfAny(reader, point, "axis"));
    if (!axis) {
      reader.blame(point.path + ".axis is not x, y or z");
      break;
    }
    summary.grid.push_back({static_cast<int>(field::indexOf(*axis)), reader.number(point, "field_T"),
                            reader.number(point, "probe_C"), reader.number(point, "electronics_C"),
                            reader.number(point, "expanded_T")});
  }
  return summary;
}

} // namespace straightedge::exporting
