#include "app/gui/field_steps/field_export_presenter.h"

#include "app/gui/field_steps/field_page_figures.h"

namespace straightedge::gui {

FieldExportPresenter::FieldExportPresenter(FieldDocument& document, JobRunner& jobs, QObject* parent)
    : ExportPresenter(document, jobs, tr("Field calibration"), parent), m_field(document) {
  connect(&document, &FieldDocument::runChanged, this, &FieldExportPresenter::forgetWritten);
  connect(&document, &FieldDocument::choicesChanged, this, &FieldExportPresenter::forgetWritten);
  connect(&document, &FieldDocument::comparisonChanged, this, &FieldExportPresenter::changed);
  connect(&document, &FieldDocument::verificationChanged, this, &FieldExportPresenter::forgetWritten);
}

// What the document shares is never changed: listing and job may look at the same.
std::vector<FileToWrite> FieldExportPresenter::files(FilesFor /*use*/) const {
  return filesToWrite(resultsOf(m_field), choices());
}

QString FieldExportPresenter::missing() const {
  if (m_field.run()) {
    return {};
  }
  return m_field.campaign().rows.empty()
             ? tr("There is nothing to export yet: capture a campaign or import a CSV file first.")
             : tr("The calibration is not computed: see the step Fit.");
}

} // namespace straightedge::gui
