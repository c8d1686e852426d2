#include "app/gui/steps/export_presenter.h"

#include "app/gui/figures/figure_parts.h"
#include "app/gui/jobs/job_runner.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

#include <algorithm>

namespace straightedge::gui {

namespace {

const QString exportJob = QStringLiteral("export");

} // namespace

ExportPresenter::ExportPresenter(AngleDocument& document, JobRunner& jobs, QObject* parent)
    : QObject(parent), m_document(document), m_jobs(jobs) {
  connect(&document, &AngleDocument::opened, this, [this] {
    m_folder.clear();
    forgetWritten();
  });
  connect(&document, &AngleDocument::titleChanged, this, &ExportPresenter::changed);
  connect(&document, &AngleDocument::runChanged, this, &ExportPresenter::forgetWritten);
  connect(&document, &AngleDocument::choicesChanged, this, &ExportPresenter::forgetWritten);
  connect(&document, &AngleDocument::comparisonChanged, this, &ExportPresenter::changed);
  connect(&document, &AngleDocument::verificationChanged, this, &ExportPresenter::forgetWritten);
  connect(&jobs, &JobRunner::jobProgress, this, [this](const QString& key, double fraction) {
    if (key == exportJob) {
      m_progress = fraction;
      emit progressChanged();
    }
  });
  connect(&jobs, &JobRunner::jobEnded, this, [this](const QString& key, bool cancelled) {
    if (key == exportJob && cancelled) {
      m_status = tr("The export was stopped. Unless it was just finishing, nothing was written.");
      m_failed = true;
      emit changed();
    }
  });
}

QString ExportPresenter::folder() const { return m_folder.isEmpty() ? suggestedFolder() : m_folder; }

void ExportPresenter::setFolder(const QString& folder) {
  m_folder = QDir::cleanPath(folder.trimmed());
  if (folder.trimmed().isEmpty()) {
    m_folder.clear();
  }
  forgetWritten();
}

void ExportPresenter::forgetWritten() {
  m_written.clear();
  if (!isRunning()) {
    m_status.clear();
    m_failed = false;
  }
  emit changed();
}

QString ExportPresenter::suggestedFolder() const {
  const QString name = m_document.isScratch() || m_document.file().isEmpty()
                           ? tr("Angle calibration")
                           : QFileInfo(m_document.file()).completeBaseName();
  const QString parent = m_document.isScratch() || m_document.file().isEmpty()
                             ? QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)
                             : QFileInfo(m_document.file()).absolutePath();
  return QDir::cleanPath(parent + QLatin1Char('/') + name + tr(" export"));
}

void ExportPresenter::setChoices(const ExportChoices& choices) {
  if (m_choices != choices) {
    m_choices = choices;
    forgetWritten();
  }
}

std::shared_ptr<const AngleResults> ExportPresenter::results(bool ownSweep) const {
  auto results = std::make_shared<AngleResults>();
  results->run = m_document.run();
  if (!results->run) {
    return results;
  }
  results->calibration = results->run->result;
  results->sweep = ownSweep ? std::make_shared<const angle::Sweep>(m_document.sweep())
                            : std::shared_ptr<const angle::Sweep>(std::shared_ptr<void>(), &m_document.sweep());
  results->comparison = m_document.comparison();
  results->verification = m_document.verification();
  const AngleChoices& choices = m_document.choices();
  results->selected = choices.selected;
  results->targetErrorDeg = choices.targetErrorDeg;
  results->budgetEntries = choices.budgetEntries;
  results->bits = choices.bits;
  return results;
}

QStringList ExportPresenter::fileNames() const {
  QStringList names;
  if (m_document.run()) {
    for (const FileToWrite& file : filesToWrite(results(false), m_choices)) {
      names << file.name;
    }
  }
  return names;
}

QStringList ExportPresenter::existing() const {
  QStringList there;
  const QDir target(folder());
  for (const QString& name : fileNames()) {
    if (target.exists(name)) {
      there << name;
    }
  }
  return there;
}

QString ExportPresenter::missing() const {
  if (m_document.run()) {
    return {};
  }
  return m_document.sweep().size() == 0
             ? tr("There is nothing to export yet: capture a sweep or import a CSV file first.")
             : tr("The calibration is not computed: see the step Fit.");
}

bool ExportPresenter::canStart() const { return m_document.run() && !isRunning() && !fileNames().isEmpty(); }

void ExportPresenter::start() {
  if (!canStart()) {
    return;
  }
  m_progress = 0.0;
  m_status.clear();
  m_failed = false;
  m_written.clear();
  m_writtenFolder = folder();
  m_jobs.run<QStringList>(
      exportJob, tr("Exporting"),
      [results = results(true), choices = m_choices, target = m_writtenFolder](const JobControl& job) {
        return writeFiles(filesToWrite(results, choices), target, job);
      },
      [this](Result<QStringList> names) {
        m_failed = !names;
        m_status = names
                       ? tr("%1 files written to %2.").arg(names->size()).arg(QDir::toNativeSeparators(m_writtenFolder))
                       : fromText(names.error().message());
        m_written = names.value_or(QStringList{});
        emit changed();
      });
  emit changed();
}

void ExportPresenter::stop() { m_jobs.cancel(exportJob); }

bool ExportPresenter::isRunning() const { return m_jobs.isRunning(exportJob); }

QString ExportPresenter::statusText() const { return m_status; }

} // namespace straightedge::gui
