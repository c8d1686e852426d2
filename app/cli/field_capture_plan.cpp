#include "app/cli/field_capture_plan.h"

#include "app/cli/messages.h"
#include "core/field/names.h"
#include "devices/capture/field_needs.h"

#include <utility>

namespace straightedge::cli {

bool changesPlan(const FieldCaptureRequest& request) {
  return !request.stages.empty() || !request.axes.empty() || !request.fieldsT.empty() ||
         !request.temperaturesC.empty() || request.rows || request.sweepRows || request.rowS || request.settleS ||
         request.temperatureSettleS || request.lockTimeoutS || request.retries;
}

Result<devices::FieldPlan> requestedPlan(const FieldCaptureRequest& request) {
  devices::FieldPlanShape shape;
  for (const std::string& name : request.stages) {
    const auto step = field::parseStep(name);
    if (!step) {
      std::string known;
      for (const auto each : field::allSteps) {
        known += (known.empty() ? "" : ", ") + std::string(field::stepName(each));
      }
      return fail(ErrorKind::Usage, "--stages: there is no step '" + name + "'", "choose from " + known);
    }
    shape.steps.push_back(*step);
  }
  for (const std::string& name : request.axes) {
    const auto axis = field::parseAxis(name);
    if (!axis) {
      return fail(ErrorKind::Usage, "--axes: there is no axis '" + name + "'", "choose from x, y, z");
    }
    shape.axes.push_back(*axis);
  }
  if (!request.fieldsT.empty()) {
    shape.fieldsT = request.fieldsT;
  }
  if (request.temperaturesC.size() == 2) {
    shape.lowC = request.temperaturesC[0];
    shape.highC = request.temperaturesC[1];
  }
  shape.rows = request.rows;
  shape.sweepRows = request.sweepRows;
  shape.rowS = request.rowS;
  shape.settleS = request.settleS;
  shape.temperatureSettleS = request.temperatureSettleS;
  shape.lockTimeoutS = request.lockTimeoutS;
  devices::FieldPlan plan = devices::makeFieldPlan(shape);
  plan.retries = request.retries.value_or(plan.retries);
  if (auto checked = devices::checkPlan(plan); !checked) {
    return std::unexpected(std::move(checked.error()));
  }
  return plan;
}

Result<void> fitToBench(devices::FieldPlan& plan, const devices::FieldBench& bench, bool stepsAsked) {
  devices::FieldPlan fitting = plan;
  const std::string leftOut = devices::leaveOutWhatIsLacking(fitting, bench);
  if (stepsAsked || !devices::checkPlan(fitting)) { // nothing would be left
    return devices::checkNeeds(plan, bench);
  }
  if (!leftOut.empty()) {
    printWarning("bench " + bench.name + " cannot measure " + leftOut + ": left out, and these corrections stay off");
  }
  plan = std::move(fitting);
  return {};
}

} // namespace straightedge::cli
