// What the step Export says and does, without widgets: what to write where, progress, and what was written.
#pragma once

#include "app/gui/document/angle_document.h"
#include "app/gui/figures/export_files.h"

#include <QObject>
#include <QString>
#include <QStringList>

namespace straightedge::gui {

class JobRunner;

/// GUI thread; files are made and written in a job.
class ExportPresenter : public QObject {
  Q_OBJECT
public:
  ExportPresenter(AngleDocument& document, JobRunner& jobs, QObject* parent = nullptr);

  QString folder() const;
  void setFolder(const QString& folder);
  /// Below the user's documents, named after the calibration; the document's own folder once it is saved.
  QString suggestedFolder() const;
  const ExportChoices& choices() const { return m_choices; }
  void setChoices(const ExportChoices& choices);

  QStringList fileNames() const; ///< what the choices come to now
  QStringList existing() const;  ///< those of them that are in the folder already and would be replaced
  QString missing() const;       ///< a calibration is needed first
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

private:
  void forgetWritten(); ///< what was written is no longer what would be written

  /// Without `ownSweep` the document's own sweep is looked at, for use at once.
  std::shared_ptr<const AngleResults> results(bool ownSweep) const;

  AngleDocument& m_document;
  JobRunner& m_jobs;
  QString m_folder; ///< empty: the suggested one
  ExportChoices m_choices;
  double m_progress = 0.0;
  QStringList m_written;
  QString m_writtenFolder;
  QString m_status;
  bool m_failed = false;
};

} // namespace straightedge::gui
