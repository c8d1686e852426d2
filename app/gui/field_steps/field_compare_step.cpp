#include "app/gui/field_steps/field_step_pages.h"
#include "app/gui/steps/placeholder_step.h"

namespace straightedge::gui {

StepPage* makeFieldCompareStep(FieldStepContext, QWidget* parent) {
  return new PlaceholderStep(QStringLiteral("Compare"), QStringLiteral("field"), parent);
}

} // namespace straightedge::gui
