// The seven steps of an angle calibration in their order, and who makes their pages.
#pragma once

#include "app/gui/shell/step_entry.h"
#include "app/gui/steps/step_page.h"

#include <array>
#include <cstddef>

namespace straightedge::gui {

inline constexpr std::size_t stepCount = 7;
const std::array<StepEntry, stepCount>& stepCatalogue();
StepPage* makeAngleStep(std::size_t step, StepContext context, QWidget* parent);
/// −1 where no step has that name.
int stepIndex(const QString& title);

} // namespace straightedge::gui
