#include "app/gui/steps/placeholder_step.h"

namespace straightedge::gui {

StepPage* makeFitStep(StepContext, QWidget* parent) { return new PlaceholderStep("Fit", "fit", parent); }
StepPage* makeCompareStep(StepContext, QWidget* parent) { return new PlaceholderStep("Compare", "compare", parent); }
StepPage* makeVerifyStep(StepContext, QWidget* parent) { return new PlaceholderStep("Verify", "verify", parent); }
StepPage* makeExportStep(StepContext, QWidget* parent) { return new PlaceholderStep("Export", "export", parent); }

} // namespace straightedge::gui
