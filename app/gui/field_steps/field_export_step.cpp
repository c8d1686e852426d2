#include "app/gui/field_steps/field_export_presenter.h"
#include "app/gui/field_steps/field_step_pages.h"
#include "app/gui/steps/export_step.h"

namespace straightedge::gui {

StepPage* makeFieldExportStep(FieldStepContext context, QWidget* parent) {
  const auto say = [](const char* text) { return FieldExportPresenter::tr(text); };
  const QList<ExportRow> rows{
      {say("Calibration"),
       {{say("JSON"), QStringLiteral("exportCalibration"),
         say("calibration.json: every block with its coefficients, verification, uncertainty and traceability"),
         &ExportChoices::calibration}}},
      {say("Coefficients"),
       {{say("CSV"), QStringLiteral("exportTablesCsv"),
         say("coefficients.csv with all of them, and a table for each block, for firmware and spreadsheets"),
         &ExportChoices::tablesCsv}}},
      {say("Readings"),
       {{say("CSV"), QStringLiteral("exportCampaign"), say("campaign.csv: the rows the calibration was made from"),
         &ExportChoices::sweep}}}};
  return new ExportStep(std::make_unique<FieldExportPresenter>(context.document, context.jobs),
                        QStringLiteral("field-export"), rows + ExportStep::pictureRows(), parent);
}

} // namespace straightedge::gui
