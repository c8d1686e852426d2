#include "app/gui/steps/placeholder_step.h"

namespace straightedge::gui {

StepPage* makeReviewStep(StepContext, QWidget* parent) { return new PlaceholderStep("Review", "review", parent); }

} // namespace straightedge::gui
