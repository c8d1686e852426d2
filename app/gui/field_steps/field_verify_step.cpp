#include "app/gui/field_steps/field_step_pages.h"
#include "app/gui/steps/placeholder_step.h"

namespace straightedge::gui {

StepPage* makeFieldVerifyStep(FieldStepContext, QWidget* parent) {
  return new PlaceholderStep(QStringLiteral("Verify"), QStringLiteral("field"), parent);
}

} // namespace straightedge::gui
