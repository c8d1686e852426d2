// The seven steps in their order: name, help page, and who makes the page.
#pragma once

#include "app/gui/steps/step_page.h"

#include <array>
#include <cstddef>

namespace straightedge::gui {

struct StepEntry {
  const char* title;
  const char* helpPage;
  const char* hint; ///< what the step is for, in the step bar's tooltip
  StepPage* (*make)(StepContext context, QWidget* parent);
};

inline constexpr std::size_t stepCount = 7;
const std::array<StepEntry, stepCount>& stepCatalogue();
/// −1 where no step has that name.
int stepIndex(const QString& title);

} // namespace straightedge::gui
