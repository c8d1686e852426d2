#include "app/gui/steps/angle_export_presenter.h"

namespace straightedge::gui {

AngleExportPresenter::AngleExportPresenter(AngleDocument& document, JobRunner& jobs, QObject* parent)
    : ExportPresenter(document, jobs, tr("Angle calibration"), parent), m_angle(document) {
  connect(&document, &AngleDocument::runChanged, this, &AngleExportPresenter::forgetWritten);
  connect(&document, &AngleDocument::choicesChanged, this, &AngleExportPresenter::forgetWritten);
  connect(&document, &AngleDocument::comparisonChanged, this, &AngleExportPresenter::changed);
  connect(&document, &AngleDocument::verificationChanged, this, &AngleExportPresenter::forgetWritten);
}

std::vector<FileToWrite> AngleExportPresenter::files(FilesFor use) const {
  auto results = std::make_shared<AngleResults>();
  results->run = m_angle.run();
  results->calibration = results->run->result;
  // A sweep that is only looked at need not be copied.
  results->sweep = use == FilesFor::Job
                       ? std::make_shared<const angle::Sweep>(m_angle.sweep())
                       : std::shared_ptr<const angle::Sweep>(std::shared_ptr<void>(), &m_angle.sweep());
  results->comparison = m_angle.comparison();
  results->verification = m_angle.verification();
  const AngleChoices& chosen = m_angle.choices();
  results->selected = chosen.selected;
  results->targetErrorDeg = chosen.targetErrorDeg;
  results->budgetEntries = chosen.budgetEntries;
  results->bits = chosen.bits;
  return filesToWrite(results, choices());
}

QString AngleExportPresenter::missing() const {
  if (m_angle.run()) {
    return {};
  }
  return m_angle.sweep().size() == 0 ? tr("There is nothing to export yet: capture a sweep or import a CSV file first.")
                                     : tr("The calibration is not computed: see the step Fit.");
}

} // namespace straightedge::gui
