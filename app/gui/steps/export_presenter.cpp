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

ExportPresenter::ExportPresenter(CalibrationDocument& document, JobRunner& jobs, const QString& folderName,
                                 QObject* parent)
    : QObject(parent), m_document(document), m_jobs(jobs), m_folderName(folderName) {
  connect(&document, &CalibrationDocument::opened, this, [this] {
    m_folder.clear();
    forgetWritten();
  });
  connect(&document, &CalibrationDocument::titleChanged, this, &ExportPresenter::changed);
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
                           ? m_folderName
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

QStringList ExportPresenter::fileNames() const {
  QStringList names;
  if (missing().isEmpty()) {
    for (const FileToWrite& file : files(FilesFor::Listing)) {
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

bool ExportPresenter::canStart() const { return missing().isEmpty() && !isRunning() && !fileNames().isEmpty(); }

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
      [files = files(FilesFor::Job), target = m_writtenFolder](const JobControl& job) {
        return writeFiles(files, target, job);
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
