#include "app/gui/field_steps/field_step_pages.h"
#include "app/gui/steps/placeholder_step.h"

namespace straightedge::gui {

StepPage* makeFieldExportStep(FieldStepContext, QWidget* parent) {
  return new PlaceholderStep(QStringLiteral("Export"), QStringLiteral("field"),
                             QStringLiteral("Export with straightedge-cli field fit and export."), parent);
}

} // namespace straightedge::gui
