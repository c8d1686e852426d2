// From the options of `capture field` to the plan of its stages.
#pragma once

#include "app/cli/field_capture_run.h"
#include "devices/capture/field_plan.h"

namespace straightedge::cli {

bool changesPlan(const FieldCaptureRequest& request); ///< an option of the plan was given

/// Errors (Usage): a step or axis that does not exist, what is out of range.
Result<devices::FieldPlan> requestedPlan(const FieldCaptureRequest& request);

/// Steps that were asked for must be possible; of those that were not, the ones that the bench cannot measure are left
/// out, and that is said. Errors (Instrument): what the bench lacks.
Result<void> fitToBench(devices::FieldPlan& plan, const devices::FieldBench& bench, bool stepsAsked);

} // namespace straightedge::cli
