// Opening, importing, saving, closing.
#include "app/gui/document/scratch_folder.h"
#include "app/gui/shell/import_dialog.h"
#include "app/gui/shell/main_window.h"
#include "app/gui/shell/message_bar.h"
#include "app/gui/shell/start_page.h"

#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QFile>
#include <QFileInfo>
#include <QMimeData>
#include <QSettings>
#include <QStandardPaths>
#include <QTimer>

#include <utility>

namespace straightedge::gui {

namespace {

constexpr int connectStep = 0;
constexpr int captureStep = 1;
constexpr int reviewStep = 2;
constexpr int verifyStep = 5;

bool isSession(const QString& file) { return file.endsWith(".sedge", Qt::CaseInsensitive); }

QStringList localFiles(const QMimeData& data) {
  QStringList files;
  const auto urls = data.urls();
  for (const QUrl& url : urls) {
    if (url.isLocalFile()) {
      files << url.toLocalFile();
    }
  }
  return files;
}

} // namespace

QString MainWindow::folderForDialogs() const {
  const QString last = QSettings().value("lastFolder").toString();
  return last.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) : last;
}

void MainWindow::newCalibration() {
  if (!leaveCalibration()) {
    return;
  }
  if (auto created = m_document.createScratch(); !created) {
    complain(created.error());
    showStart();
    return;
  }
  goToStep(connectStep);
}

void MainWindow::startSimulatedBench() {
  newCalibration();
  if (!m_document.isOpen()) {
    return;
  }
  if (!m_bench.isConnected() || m_bench.benchName() != tr("Simulated bench")) {
    if (auto connected = m_bench.connectSimulated(m_bench.simulatedSettings()); !connected) {
      complain(connected.error());
      return;
    }
  }
  goToStep(captureStep);
}

void MainWindow::openDialog() {
  if (const QString file = m_prompts->askOpenFile(this, folderForDialogs()); !file.isEmpty()) {
    openFile(file);
  }
}

bool MainWindow::openFile(const QString& file) {
  const QFileInfo info(file);
  if (!info.exists()) {
    complain(
        {ErrorKind::Input, "there is no such file", "check the name, or remove it from the list", file.toStdString()});
    return false;
  }
  if (info.isDir()) {
    complain({ErrorKind::Input, "this is a folder", "choose a calibration (.sedge) or a sweep (.csv) in it",
              file.toStdString()});
    return false;
  }
  if (isSession(file)) {
    return openSession(info.absoluteFilePath());
  }
  importCsv(info.absoluteFilePath()); // anything else is looked at: the preview says why it is no sweep
  return true;
}

bool MainWindow::openSession(const QString& file) {
  if (m_document.isOpen() && m_document.file() == file) {
    return true;
  }
  m_messages->dismiss();
  // Asked before the open calibration is closed for its sake.
  if (auto possible = AngleDocument::probe(file); !possible) {
    complain(possible.error());
    return false;
  }
  if (!leaveCalibration()) {
    return false;
  }
  if (auto opened = m_document.open(file); !opened) {
    complain(opened.error());
    showStart();
    return false;
  }
  if (!m_document.isScratch()) {
    m_recent.add(file);
    QSettings().setValue("lastFolder", QFileInfo(file).absolutePath());
  }
  goToStep(m_document.sweep().size() > 0 ? reviewStep : connectStep);
  return true;
}

void MainWindow::openExample(const QString& resource) {
  QFile file(resource);
  if (!file.open(QIODevice::ReadOnly)) {
    complain({ErrorKind::Storage, "the example is not part of this program", "reinstall Straightedge",
              resource.toStdString()});
    return;
  }
  const std::string name = QFileInfo(resource).fileName().toStdString();
  auto sweep = angle::parseSweepCsv(file.readAll().toStdString(), name, name);
  if (!sweep) {
    complain(sweep.error());
    return;
  }
  newCalibration();
  if (m_document.isOpen()) {
    useSweep(std::move(*sweep), QString::fromStdString(name), false);
  }
}

void MainWindow::importDialogForFile() {
  if (const QString file = m_prompts->askCsvFile(this, folderForDialogs()); !file.isEmpty()) {
    importCsv(file);
  }
}

void MainWindow::importCsv(const QString& file) {
  m_messages->dismiss();
  m_jobs.run<angle::CsvPreview>(
      "inspect-csv", tr("Reading %1").arg(QFileInfo(file).fileName()),
      [path = file.toStdString()](const JobControl&) { return angle::inspectCsv(path); },
      [this, file](Result<angle::CsvPreview> preview) {
        if (!preview) {
          complain(preview.error());
          return;
        }
        showImport(file, *preview);
      });
}

void MainWindow::showImport(const QString& file, const angle::CsvPreview& preview) {
  if (m_import) {
    m_import->close();
  }
  const bool canVerify = m_document.isOpen() && m_document.sweep().size() > 0;
  m_import = new ImportDialog(file, preview, canVerify && m_currentStep == verifyStep, canVerify, this);
  m_import->setAttribute(Qt::WA_DeleteOnClose);
  connect(m_import, &QDialog::accepted, this,
          [this, file, dialog = m_import.data()] { readSweep(file, dialog->mapping(), dialog->forVerification()); });
  m_import->open();
}

ImportDialog* MainWindow::importDialog() const { return m_import; }

void MainWindow::readSweep(const QString& file, const angle::SweepMapping& mapping, bool forVerification) {
  m_jobs.run<angle::Sweep>(
      "read-csv", tr("Reading %1").arg(QFileInfo(file).fileName()),
      [path = file.toStdString(), mapping](const JobControl&) { return angle::readSweepCsv(path, mapping); },
      [this, file, forVerification](Result<angle::Sweep> sweep) {
        if (!sweep) {
          complain(sweep.error());
          return;
        }
        QSettings().setValue("lastFolder", QFileInfo(file).absolutePath());
        if (!m_document.isOpen()) {
          newCalibration();
        }
        if (m_document.isOpen()) {
          useSweep(std::move(*sweep), QFileInfo(file).fileName(), forVerification);
        }
      });
}

void MainWindow::useSweep(angle::Sweep sweep, const QString& name, bool forVerification) {
  const auto points = sweep.size();
  if (forVerification) {
    m_document.setVerificationSweep(std::move(sweep));
    goToStep(verifyStep);
  } else {
    m_document.setSweep(std::move(sweep), tr("import %1").arg(name));
    goToStep(reviewStep);
  }
  updateTitle();
  tell(tr("%1 points read from %2").arg(points).arg(name));
}

bool MainWindow::save() {
  if (!m_document.isOpen()) {
    return false;
  }
  if (m_document.isScratch() || m_document.isReadOnly()) {
    return saveAs();
  }
  if (auto written = m_document.saveAs(m_document.file()); !written) {
    complain(written.error());
    return false;
  }
  updateTitle();
  tell(tr("Saved. Straightedge writes every change to the file as it happens."));
  return true;
}

bool MainWindow::saveAs() {
  if (!m_document.isOpen()) {
    return false;
  }
  if (m_bench.isCapturing()) {
    complain({ErrorKind::Usage, "a capture is running into this session", "stop or pause the sweep, then save", ""});
    return false;
  }
  const QString stem = m_document.isScratch() ? tr("calibration") : m_document.displayName();
  const QString file = m_prompts->askSaveFile(this, folderForDialogs() + "/" + stem + ".sedge");
  return !file.isEmpty() && saveTo(file);
}

bool MainWindow::saveTo(const QString& file) {
  if (auto saved = m_document.saveAs(file); !saved) {
    complain(saved.error());
    return false;
  }
  m_recent.add(file);
  QSettings().setValue("lastFolder", QFileInfo(file).absolutePath());
  updateTitle();
  tell(tr("Saved as %1").arg(QFileInfo(file).fileName()));
  return true;
}

bool MainWindow::leaveCalibration() {
  if (!m_document.isOpen()) {
    return true;
  }
  if (m_bench.isCapturing()) {
    if (!m_prompts->confirmStopCapture(this)) {
      return false;
    }
    m_bench.stopAndWait();
  }
  if (m_document.isScratch() && m_document.hasContent()) {
    switch (m_prompts->askClose(this)) {
    case WindowPrompts::CloseAnswer::Cancel:
      return false;
    case WindowPrompts::CloseAnswer::Save:
      if (!saveAs()) {
        return false;
      }
      break;
    case WindowPrompts::CloseAnswer::Discard:
      if (auto gone = m_document.discard(); !gone) {
        complain(gone.error());
      }
      return true;
    case WindowPrompts::CloseAnswer::KeepForLater:
      break;
    }
  } else if (m_document.isReadOnly() && m_document.hasUnsavedState()) {
    if (!m_prompts->confirmLoss(this, tr("The file is on read-only media. “Save As” keeps the changes elsewhere."))) {
      return false;
    }
    static_cast<void>(m_document.discard()); // read-only: there is nothing to write
    return true;
  }
  if (auto closed = m_document.close(); !closed) {
    if (m_document.isOpen()) {
      if (!m_prompts->confirmLoss(this, QString::fromStdString(closed.error().message()))) {
        complain(closed.error());
        return false;
      }
      static_cast<void>(m_document.abandon());
    } else {
      complain(closed.error());
    }
  }
  return true;
}

bool MainWindow::closeCalibration() {
  if (!leaveCalibration()) {
    return false;
  }
  showStart();
  return true;
}

void MainWindow::deleteUnsaved(const QString& file) {
  const QString when = QLocale().toString(QFileInfo(file).lastModified(), QLocale::LongFormat);
  if (!m_prompts->confirmDelete(this,
                                tr("It was last changed on %1. Its samples and choices are deleted.").arg(when))) {
    return;
  }
  // Taken and kept until it is gone, so that no other window opens it meanwhile.
  if (auto lock = ScratchFolder::lock(file)) {
    ScratchFolder::remove(file);
  } else {
    complain(lock.error());
  }
  m_start->refresh();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!leaveCalibration()) {
    event->ignore();
    return;
  }
  saveLayout();
  event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!localFiles(*event->mimeData()).isEmpty()) {
    event->acceptProposedAction();
  }
}

void MainWindow::dropEvent(QDropEvent* event) {
  const QStringList files = localFiles(*event->mimeData());
  if (files.isEmpty()) {
    return;
  }
  event->acceptProposedAction();
  if (files.size() > 1) {
    complain({ErrorKind::Usage, "several files were dropped; one calibration is open at a time", "drop one file", ""});
    return;
  }
  // After the drop has ended: the program that dragged would otherwise wait for our dialogues.
  QTimer::singleShot(0, this, [this, file = files.first()] { openFile(file); });
}

} // namespace straightedge::gui
