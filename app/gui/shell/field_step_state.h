// How far each step of a field calibration is, from the calibration and the bench alone.
#pragma once

#include "app/gui/shell/step_entry.h"

namespace straightedge::gui {

class FieldBenchLink;
class FieldDocument;

StepState fieldStepState(std::size_t step, const FieldDocument& document, const FieldBenchLink& bench);

} // namespace straightedge::gui
