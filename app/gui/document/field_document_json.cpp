#include "app/gui/document/field_document_json.h"

#include "app/gui/document/json_parts.h"
#include "core/field/block_names.h"
#include "core/field/campaign_csv.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace straightedge::gui {

namespace {

const char* percentWord(field::PercentOf of) { return of == field::PercentOf::Reading ? "reading" : "full-scale"; }

/// Only what makes sense: a full scale of nothing would refuse every campaign for good.
double positiveOr(const nlohmann::json& object, const char* key, double otherwise) {
  const double value = numberOr(object, key, otherwise);
  return std::isfinite(value) && value > 0.0 ? value : otherwise;
}

std::vector<std::int64_t> linesOf(const field::Campaign& campaign) {
  std::vector<std::int64_t> lines;
  lines.reserve(campaign.rows.size());
  for (const auto& row : campaign.rows) {
    lines.push_back(row.line);
  }
  return lines;
}

} // namespace

std::string fieldChoicesToJson(const FieldChoices& choices) {
  nlohmann::json off = nlohmann::json::array();
  for (const field::Block block : choices.blocksOff) {
    off.push_back(std::string(field::blockName(block)));
  }
  const auto method = field::methodWords[static_cast<std::size_t>(choices.method)].second;
  return nlohmann::json{{"order", choices.order},
                        {"method", std::string(method)},
                        {"full_scale_T", choices.fullScaleT},
                        {"reference_temperature_C", choices.referenceTemperatureC},
                        {"blocks_off", off},
                        {"limit_percent", choices.limitPercent},
                        {"percent_of", percentWord(choices.percentOf)}}
      .dump();
}

Result<FieldChoices> fieldChoicesFromJson(std::string_view text) {
  const nlohmann::json object = jsonObjectFrom(text);
  if (object.is_discarded()) {
    return unreadableDocument(fieldChoicesDocument);
  }
  FieldChoices choices;
  if (const auto order = object.find("order"); order != object.end() && order->is_number_integer()) {
    choices.order = std::clamp(order->get<int>(), field::lowestOrder, field::highestOrder);
  }
  const std::string method = textOr(object, "method", "");
  for (const auto& [value, word] : field::methodWords) {
    if (method == word) {
      choices.method = value;
    }
  }
  choices.fullScaleT = positiveOr(object, "full_scale_T", choices.fullScaleT);
  choices.referenceTemperatureC = numberOr(object, "reference_temperature_C", choices.referenceTemperatureC);
  choices.limitPercent = positiveOr(object, "limit_percent", choices.limitPercent);
  choices.percentOf =
      textOr(object, "percent_of", "") == "reading" ? field::PercentOf::Reading : field::PercentOf::FullScale;
  if (const auto off = object.find("blocks_off"); off != object.end() && off->is_array()) {
    for (const auto& [block, word] : field::blockWords) {
      if (std::find(off->begin(), off->end(), std::string(word)) != off->end()) {
        choices.blocksOff.insert(block);
      }
    }
  }
  return choices;
}

std::string switchedOffToJson(const std::vector<bool>& enabled) {
  nlohmann::json off = nlohmann::json::array();
  for (std::size_t row = 0; row < enabled.size(); ++row) {
    if (!enabled[row]) {
      off.push_back(row);
    }
  }
  return nlohmann::json{{"switched_off", off}}.dump();
}

std::string campaignToJson(const field::Campaign& campaign) {
  nlohmann::json object{
      {"source", {{"file", campaign.name}, {"sha256", campaign.sha256}, {"rows", campaign.rows.size()}}},
      {"csv", field::campaignCsv(campaign)}};
  columnFrom(object, "line", linesOf(campaign));
  return object.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

Result<field::Campaign> campaignFromJson(std::string_view text) {
  const nlohmann::json object = jsonObjectFrom(text);
  std::vector<std::int64_t> lines;
  if (object.is_discarded() || !columnInto(object, "line", lines)) {
    return unreadableDocument(importedCampaignDocument);
  }
  const auto source = object.find("source");
  const bool known = source != object.end() && source->is_object();
  const std::string name = known ? textOr(*source, "file", "") : std::string();
  auto campaign = field::parseCampaignCsv(textOr(object, "csv", ""), name, name);
  if (!campaign || (!lines.empty() && lines.size() != campaign->rows.size())) {
    return unreadableDocument(importedCampaignDocument);
  }
  campaign->sha256 = known ? textOr(*source, "sha256", "") : std::string();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    campaign->rows[i].line = lines[i];
  }
  return campaign;
}

} // namespace straightedge::gui
