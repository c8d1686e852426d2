#include "core/field/span_checks.h"

#include "core/field/messages.h"
#include "core/field/names.h"

namespace straightedge::field {

Result<void> checkRowCount(const StepRows& rows, const std::string& name) {
  if (rows.size() >= leastRows) {
    return {};
  }
  std::string step(stepName(rows.step));
  if (rows.axis) {
    step += " of axis " + std::string(axisName(*rows.axis));
  }
  if (rows.recorded > 0 && rows.unlocked == rows.recorded) {
    return campaignFault(
        name, 0, "the reference was never locked in the " + counted(rows.recorded, "row") + " of the step " + step,
        "check the reference's probe and range and record the step again");
  }
  std::string what = "only " + counted(static_cast<std::size_t>(rows.size()), "row") + " of the step " + step +
                     " can be used, " + std::to_string(leastRows) + " are needed";
  if (rows.unlocked + rows.incomplete > 0) {
    what += " (" + std::to_string(rows.unlocked) + " not locked, " + std::to_string(rows.incomplete) + " incomplete)";
  }
  return campaignFault(name, 0, std::move(what), "record the step again");
}

Result<void> checkSpan(const Eigen::VectorXd& temperatureC, const std::string& thing, const std::string& step,
                       const std::string& name) {
  const double span = temperatureC.maxCoeff() - temperatureC.minCoeff();
  if (span >= leastSpanC) {
    return {};
  }
  return campaignFault(name, 0,
                       "the temperature of the " + thing + " does not move in the step " + step + ": it stays within " +
                           celsiusText(span),
                       "sweep it over the working range, by at least " + celsiusText(leastSpanC));
}

} // namespace straightedge::field
