// What the stages of a field plan need of a bench.
#pragma once

#include "devices/capture/field_plan.h"
#include "devices/instruments/field_bench.h"

#include <string>
#include <vector>

namespace straightedge::devices {

/// What the bench lacks of that without which the stage's rows are of no use to the fit, with the role that fills it:
/// "a PT100 meter (resistance)". Empty: the stage can be measured. Magnet, carrier and chambers are never missing: a
/// person takes their place.
std::string lackingFor(const FieldStage& stage, const FieldBench& bench);

/// Leaves out the stages that the bench cannot measure; returns a sentence for people about them, empty where there are
/// none.
std::string leaveOutWhatIsLacking(FieldPlan& plan, const FieldBench& bench);

/// Errors (Instrument): stages that the bench cannot measure, and what it lacks.
Result<void> checkNeeds(const FieldPlan& plan, const FieldBench& bench);

} // namespace straightedge::devices
