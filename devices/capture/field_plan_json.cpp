// The plan of a field campaign as the JSON that a session keeps.
#include "core/field/names.h"
#include "devices/capture/field_plan.h"

#include <nlohmann/json.hpp>

namespace straightedge::devices {

std::string planToJson(const FieldPlan& plan) {
  nlohmann::ordered_json json = {{"kind", "field"},
                                 {"settle_s", plan.settleS},
                                 {"temperature_settle_s", plan.temperatureSettleS},
                                 {"lock_timeout_s", plan.lockTimeoutS},
                                 {"reference_temperature_C", plan.referenceTemperatureC},
                                 {"retries", plan.retries},
                                 {"stages", nlohmann::ordered_json::array()}};
  for (const FieldStage& stage : plan.stages) {
    nlohmann::ordered_json part = {{"step", field::stepName(stage.step)}};
    if (stage.axis) {
      part["axis"] = field::axisName(*stage.axis);
    }
    if (stage.orientation) {
      part["orientation"] = field::orientationName(*stage.orientation);
    }
    part.update({{"fields_T", stage.fieldsT},
                 {"probe_C", stage.probeC},
                 {"electronics_C", stage.electronicsC},
                 {"low_C", stage.lowC},
                 {"high_C", stage.highC},
                 {"cycles", stage.cycles},
                 {"rows", stage.rows},
                 {"row_s", stage.rowS},
                 {"skipped", stage.skipped}});
    json["stages"].push_back(std::move(part));
  }
  return json.dump();
}

namespace {

std::unexpected<Error> unreadable(const std::string& why) {
  return fail(ErrorKind::Input, "the stored capture plan cannot be read (" + why + ")", "choose the plan anew",
              "capture plan");
}

} // namespace

Result<FieldPlan> fieldPlanFromJson(std::string_view text) {
  FieldPlan plan;
  try {
    const nlohmann::json json = nlohmann::json::parse(text);
    plan.settleS = json.at("settle_s").get<double>();
    plan.temperatureSettleS = json.value("temperature_settle_s", plan.temperatureSettleS);
    plan.lockTimeoutS = json.value("lock_timeout_s", plan.lockTimeoutS);
    plan.referenceTemperatureC = json.value("reference_temperature_C", plan.referenceTemperatureC);
    plan.retries = json.value("retries", plan.retries);
    for (const auto& part : json.at("stages")) {
      FieldStage stage;
      const auto step = field::parseStep(part.at("step").get<std::string>());
      if (!step) {
        return unreadable("unknown step " + part.at("step").dump());
      }
      stage.step = *step;
      stage.axis = part.contains("axis") ? field::parseAxis(part.at("axis").get<std::string>()) : std::nullopt;
      stage.orientation = part.contains("orientation")
                              ? field::parseOrientation(part.at("orientation").get<std::string>())
                              : std::nullopt;
      stage.fieldsT = part.at("fields_T").get<std::vector<double>>();
      stage.probeC = part.value("probe_C", stage.probeC);
      stage.electronicsC = part.value("electronics_C", stage.electronicsC);
      stage.lowC = part.value("low_C", stage.lowC);
      stage.highC = part.value("high_C", stage.highC);
      stage.cycles = part.value("cycles", stage.cycles);
      stage.rows = part.at("rows").get<int>();
      stage.rowS = part.value("row_s", stage.rowS);
      stage.skipped = part.value("skipped", stage.skipped);
      plan.stages.push_back(std::move(stage));
    }
  } catch (const nlohmann::json::exception& problem) {
    return unreadable(problem.what());
  }
  if (auto checked = checkPlan(plan); !checked) {
    Error error = std::move(checked.error());
    error.kind = ErrorKind::Input;
    return std::unexpected(std::move(error));
  }
  return plan;
}

} // namespace straightedge::devices
