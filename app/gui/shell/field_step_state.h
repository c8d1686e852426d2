// How far each step of a field calibration is, from the calibration alone.
#pragma once

#include "app/gui/shell/step_entry.h"

namespace straightedge::gui {

class FieldDocument;

StepState fieldStepState(std::size_t step, const FieldDocument& document);

} // namespace straightedge::gui
