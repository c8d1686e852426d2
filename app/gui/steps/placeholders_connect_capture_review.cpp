#include "app/gui/steps/placeholder_step.h"

namespace straightedge::gui {

StepPage* makeCaptureStep(StepContext, QWidget* parent) { return new PlaceholderStep("Capture", "capture", parent); }
StepPage* makeReviewStep(StepContext, QWidget* parent) { return new PlaceholderStep("Review", "review", parent); }

} // namespace straightedge::gui
