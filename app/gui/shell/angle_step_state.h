// How far each step of an angle calibration is, from the calibration and the bench alone: the step bar shows it before
// a page exists.
#pragma once

#include "app/gui/shell/step_entry.h"

namespace straightedge::gui {

class AngleDocument;
class BenchLink;

StepState angleStepState(std::size_t step, const AngleDocument& document, const BenchLink& bench);

} // namespace straightedge::gui
