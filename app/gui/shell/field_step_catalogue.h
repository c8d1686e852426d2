// The steps of a field calibration in their order, and who makes their pages.
#pragma once

#include "app/gui/field_steps/field_step_pages.h"
#include "app/gui/shell/step_entry.h"

#include <span>

namespace straightedge::gui {

std::span<const StepEntry> fieldStepCatalogue();
StepPage* makeFieldStep(std::size_t step, FieldStepContext context, QWidget* parent);

} // namespace straightedge::gui
