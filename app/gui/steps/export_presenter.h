// What the step Export says and does, without widgets: what to write where, progress, and what was written.
#pragma once

#include "app/gui/document/calibration_document.h"
#include "app/gui/figures/export_files.h"

#include <QObject>
#include <QString>
#include <QStringList>

namespace straightedge::gui {

class JobRunner;

/// GUI thread; files are made and written in a job. What there is to write comes from the kind of calibration
/// (AngleExportPresenter, FieldExportPresenter).
class ExportPresenter : public QObject {
  Q_OBJECT
public:
  QString folder() const;
  void setFolder(const QString& folder);
  /// Below the user's documents, named after the calibration; the document's own folder once it is saved.
  QString suggestedFolder() const;
  const ExportChoices& choices() const { return m_choices; }
  void setChoices(const ExportChoices& choices);

  QStringList fileNames() const;       ///< what the choices come to now
  QStringList existing() const;        ///< those of them that are in the folder already and would be replaced
  virtual QString missing() const = 0; ///< a calibration is needed first; empty where there is one
  bool canStart() const;
  void start();
  void stop();
  bool isRunning() const;
  double progress() const { return m_progress; }

  const QStringList& written() const { return m_written; } ///< names below writtenFolder()
  QString writtenFolder() const { return m_writtenFolder; }
  QString statusText() const; ///< what was written, or what went wrong, as a sentence
  bool failed() const { return m_failed; }

signals:
  void changed();
  void progressChanged();

protected:
  /// Who may write: files that are only listed, now, or made in a job while the document goes on.
  enum class FilesFor : std::uint8_t { Listing, Job };

  /// `folderName`: of the suggested folder while the document is not saved.
  ExportPresenter(CalibrationDocument& document, JobRunner& jobs, const QString& folderName, QObject* parent);
  /// What the choices come to; asked only while nothing is missing.
  virtual std::vector<FileToWrite> files(FilesFor use) const = 0;
  void forgetWritten(); ///< what was written is no longer what would be written

private:
  CalibrationDocument& m_document;
  JobRunner& m_jobs;
  QString m_folderName;
  QString m_folder; ///< empty: the suggested one
  ExportChoices m_choices;
  double m_progress = 0.0;
  QStringList m_written;
  QString m_writtenFolder;
  QString m_status;
  bool m_failed = false;
};

} // namespace straightedge::gui
