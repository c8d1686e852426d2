#include "devices/capture/field_needs.h"

#include "core/field/names.h"

#include <algorithm>

namespace straightedge::devices {

namespace {

using field::CampaignStep;

bool needsPt100(CampaignStep step) {
  return step == CampaignStep::ProbeTemperature || step == CampaignStep::Offset || step == CampaignStep::Sensitivity;
}

bool needsElectronics(CampaignStep step) {
  return step == CampaignStep::Electronics || step == CampaignStep::ElectronicsSensitivity;
}

/// "probe-temperature, offset and sensitivity without a PT100 meter (resistance)": each step once, in the plan's order.
std::string lackingSteps(const FieldPlan& plan, const FieldBench& bench) {
  struct Group {
    std::string lacks;
    std::vector<std::string> steps;
  };
  std::vector<Group> groups;
  for (const FieldStage& stage : plan.stages) {
    const std::string lacks = stage.skipped ? std::string() : lackingFor(stage, bench);
    if (lacks.empty()) {
      continue;
    }
    auto group = std::ranges::find(groups, lacks, &Group::lacks);
    if (group == groups.end()) {
      group = groups.insert(groups.end(), Group{lacks, {}});
    }
    const std::string step(field::stepName(stage.step));
    if (std::ranges::find(group->steps, step) == group->steps.end()) {
      group->steps.push_back(step);
    }
  }
  std::string text;
  for (const Group& group : groups) {
    text += text.empty() ? "" : "; ";
    for (std::size_t i = 0; i < group.steps.size(); ++i) {
      text += (i == 0 ? "" : i + 1 == group.steps.size() ? " and " : ", ") + group.steps[i];
    }
    text += " without " + group.lacks;
  }
  return text;
}

} // namespace

std::string lackingFor(const FieldStage& stage, const FieldBench& bench) {
  std::string lacks;
  const auto add = [&lacks](bool missing, const char* what) {
    if (missing) {
      lacks += (lacks.empty() ? "" : " and ") + std::string(what);
    }
  };
  add(needsReference(stage) && bench.reference == nullptr, "a reference field (field-reference)");
  add(needsPt100(stage.step) && bench.pt100 == nullptr, "a PT100 meter (resistance)");
  add(stage.step == CampaignStep::ProbeTemperature && bench.probeChamber == nullptr && bench.chamber == nullptr,
      "a thermometer in the probe's chamber (chamber-temperature)");
  add(needsElectronics(stage.step) && bench.electronics == nullptr &&
          (bench.probe == nullptr || !bench.probe->measuresElectronics()),
      "a thermometer of the electronics (temperature)");
  return lacks;
}

std::string leaveOutWhatIsLacking(FieldPlan& plan, const FieldBench& bench) {
  std::string told = lackingSteps(plan, bench);
  for (FieldStage& stage : plan.stages) {
    stage.skipped = stage.skipped || !lackingFor(stage, bench).empty();
  }
  return told;
}

Result<void> checkNeeds(const FieldPlan& plan, const FieldBench& bench) {
  const std::string lacking = lackingSteps(plan, bench);
  if (lacking.empty()) {
    return {};
  }
  return fail(ErrorKind::Instrument, "this bench cannot measure " + lacking,
              "add what is missing to the bench, or leave these steps out", bench.name);
}

} // namespace straightedge::devices
