#include "app/gui/document/document_json.h"

#include "app/gui/document/json_parts.h"

#include <algorithm>

namespace straightedge::gui {

namespace {

using nlohmann::json;

const char* curveText(angle::CurveMethod method) {
  switch (method) {
  case angle::CurveMethod::Interpolate:
    return "interpolate";
  case angle::CurveMethod::Regress:
    return "regress";
  case angle::CurveMethod::Auto:
    break;
  }
  return "auto";
}

angle::CurveMethod curveFrom(const std::string& text) {
  if (text == "interpolate") {
    return angle::CurveMethod::Interpolate;
  }
  return text == "regress" ? angle::CurveMethod::Regress : angle::CurveMethod::Auto;
}

} // namespace

std::string choicesToJson(const AngleChoices& choices) {
  json models = json::array();
  for (const auto& model : choices.models) {
    models.push_back(model.text());
  }
  json object{{"curve", curveText(choices.curveMethod)}, {"models", models},
              {"selected", choices.selected.text()},     {"target_error_deg", choices.targetErrorDeg},
              {"budget_entries", choices.budgetEntries}, {"limit_deg", choices.limitDeg}};
  if (choices.bits) {
    object["bits"] = *choices.bits;
  }
  return object.dump();
}

Result<AngleChoices> choicesFromJson(std::string_view text) {
  const json object = jsonObjectFrom(text);
  if (object.is_discarded()) {
    return unreadableDocument(choicesDocument);
  }
  AngleChoices choices;
  choices.curveMethod = curveFrom(textOr(object, "curve", "auto"));
  if (const auto models = object.find("models"); models != object.end() && models->is_array()) {
    std::vector<angle::ModelName> names;
    for (const auto& entry : *models) {
      if (const auto name = entry.is_string() ? angle::parseModelName(entry.get<std::string>())
                                              : Result<angle::ModelName>(std::unexpected(Error{}))) {
        names.push_back(*name);
      }
    }
    if (!names.empty()) {
      choices.models = std::move(names);
    }
  }
  choices.selected = choices.models.front();
  if (const auto selected = angle::parseModelName(textOr(object, "selected", ""))) {
    choices.selected = *selected;
  }
  choices.targetErrorDeg = numberOr(object, "target_error_deg", choices.targetErrorDeg);
  choices.budgetEntries = static_cast<int>(numberOr(object, "budget_entries", choices.budgetEntries));
  choices.limitDeg = numberOr(object, "limit_deg", choices.limitDeg);
  if (const auto bits = object.find("bits"); bits != object.end() && bits->is_number_integer()) {
    choices.bits = std::clamp(bits->get<int>(), 8, 16);
  }
  return choices;
}

std::string reviewToJson(const angle::Sweep& sweep) {
  json off = json::array();
  for (std::size_t row = 0; row < sweep.size(); ++row) {
    if (!sweep.isEnabled(row)) {
      off.push_back(row);
    }
  }
  return json{{"switched_off", off}}.dump();
}

Result<std::vector<std::size_t>> reviewFromJson(std::string_view text) {
  const json object = jsonObjectFrom(text);
  std::vector<std::size_t> rows;
  if (object.is_discarded() || !columnInto(object, "switched_off", rows)) {
    return unreadableDocument(reviewDocument);
  }
  return rows;
}

std::string sweepToJson(const angle::Sweep& sweep) {
  json object{{"encoder_deg", sweep.encoderDeg},
              {"sensor_deg", sweep.sensorDeg},
              {"source", {{"file", sweep.source.file}, {"sha256", sweep.source.sha256}, {"points", sweep.size()}}}};
  columnFrom(object, "turn", sweep.turn);
  columnFrom(object, "direction", sweep.direction);
  columnFrom(object, "temperature_C", sweep.temperatureC);
  columnFrom(object, "time_s", sweep.timeS);
  columnFrom(object, "line", sweep.line);
  return object.dump(-1, ' ', false, json::error_handler_t::replace);
}

Result<angle::Sweep> sweepFromJson(std::string_view text) {
  const json object = jsonObjectFrom(text);
  angle::Sweep sweep;
  if (object.is_discarded() || !columnInto(object, "encoder_deg", sweep.encoderDeg) ||
      !columnInto(object, "sensor_deg", sweep.sensorDeg) || !columnInto(object, "turn", sweep.turn) ||
      !columnInto(object, "direction", sweep.direction) || !columnInto(object, "temperature_C", sweep.temperatureC) ||
      !columnInto(object, "time_s", sweep.timeS) || !columnInto(object, "line", sweep.line)) {
    return unreadableDocument(importedSweepDocument);
  }
  const auto fits = [&](const auto& column) { return column.empty() || column.size() == sweep.size(); };
  if (sweep.sensorDeg.size() != sweep.size() || !fits(sweep.turn) || !fits(sweep.direction) ||
      !fits(sweep.temperatureC) || !fits(sweep.timeS) || !fits(sweep.line)) {
    return unreadableDocument(importedSweepDocument);
  }
  if (const auto source = object.find("source"); source != object.end() && source->is_object()) {
    sweep.source.file = textOr(*source, "file", "");
    sweep.source.sha256 = textOr(*source, "sha256", "");
    sweep.source.points = static_cast<long long>(sweep.size());
  }
  return sweep;
}

} // namespace straightedge::gui
