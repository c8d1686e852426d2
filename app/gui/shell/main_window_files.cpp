// Opening, importing, saving, closing.
#include "app/gui/document/scratch_folder.h"
#include "app/gui/shell/data_kind.h"
#include "app/gui/shell/field_workspace.h"
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

constexpr int firstStep = 0;

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

Workspace& MainWindow::workspaceOf(session::SessionKind kind) {
  if (kind == session::SessionKind::Field) {
    return field();
  }
  return *m_angle;
}

bool MainWindow::begin(Workspace& workspace) {
  if (!leaveCalibration()) {
    return false;
  }
  use(workspace);
  if (auto created = workspace.document().createScratch(); !created) {
    complain(created.error());
    showStart();
    return false;
  }
  goToStep(firstStep);
  return true;
}

void MainWindow::newCalibration() { begin(*m_angle); }

void MainWindow::newFieldCalibration() { begin(field()); }

void MainWindow::startSimulatedBench() { startOnSimulatedBench(*m_angle); }

void MainWindow::startSimulatedFieldBench() { startOnSimulatedBench(field()); }

template <typename OwnWorkspace>
void MainWindow::startOnSimulatedBench(OwnWorkspace& workspace) {
  if (!begin(workspace)) {
    return;
  }
  const auto step = workspace.connectSimulatedBench();
  if (!step) {
    complain(step.error());
    return;
  }
  goToStep(*step);
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
    complain({ErrorKind::Input, "this is a folder", "choose a calibration (.sedge), a sweep or a campaign (.csv) in it",
              file.toStdString()});
    return false;
  }
  if (isSession(file)) {
    return openSession(info.absoluteFilePath());
  }
  importCsv(info.absoluteFilePath()); // anything else is looked at: the reader says why it is no data
  return true;
}

bool MainWindow::openSession(const QString& file) {
  if (auto& open = m_workspace->document(); open.isOpen() && open.file() == file) {
    return true;
  }
  m_messages->dismiss();
  // Asked before the open calibration is closed for its sake.
  const auto kind = CalibrationDocument::probe(file);
  if (!kind) {
    complain(kind.error());
    return false;
  }
  if (!leaveCalibration()) {
    return false;
  }
  use(workspaceOf(*kind));
  auto& document = m_workspace->document();
  if (auto opened = document.open(file); !opened) {
    complain(opened.error());
    showStart();
    return false;
  }
  if (!document.isScratch()) {
    m_recent.add(file);
    QSettings().setValue("lastFolder", QFileInfo(file).absolutePath());
  }
  goToStep(m_workspace->firstStepAfterOpening());
  return true;
}

void MainWindow::openExample(const QString& resource) {
  QFile file(resource);
  if (!file.open(QIODevice::ReadOnly)) {
    complain({ErrorKind::Storage, "the example is not part of this program", "reinstall Straightedge",
              resource.toStdString()});
    return;
  }
  const QByteArray bytes = file.readAll();
  auto& workspace = workspaceOf(dataKindOf(bytes));
  auto ready = workspace.readExample(bytes.toStdString(), QFileInfo(resource).fileName());
  if (!ready) {
    complain(ready.error());
    return;
  }
  if (begin(workspace)) {
    takeData(workspace, *ready);
  }
}

void MainWindow::importDialogForFile() {
  if (const QString file = m_prompts->askCsvFile(this, folderForDialogs()); !file.isEmpty()) {
    importCsv(file);
  }
}

void MainWindow::importCsv(const QString& file) {
  m_messages->dismiss();
  auto& workspace = workspaceOf(dataKindOfFile(file));
  workspace.importFile(file, &workspace == m_workspace ? m_currentStep : -1, *this);
}

void MainWindow::takeData(Workspace& workspace, const ReadyData& ready) {
  if (!ready.file.isEmpty()) {
    QSettings().setValue("lastFolder", QFileInfo(ready.file).absolutePath());
  }
  if ((m_workspace != &workspace || !workspace.document().isOpen()) && !begin(workspace)) {
    return;
  }
  const Landing landing = ready.put();
  goToStep(landing.step);
  updateTitle();
  tell(landing.text);
}

bool MainWindow::save() {
  auto& document = m_workspace->document();
  if (!document.isOpen()) {
    return false;
  }
  if (document.isScratch() || document.isReadOnly()) {
    return saveAs();
  }
  if (auto written = document.saveAs(document.file()); !written) {
    complain(written.error());
    return false;
  }
  updateTitle();
  tell(tr("Saved. Straightedge writes every change to the file as it happens."));
  return true;
}

bool MainWindow::saveAs() {
  const auto& document = m_workspace->document();
  if (!document.isOpen()) {
    return false;
  }
  if (m_workspace->isCapturing()) {
    complain({ErrorKind::Usage, "a capture is running into this session", "stop or pause the sweep, then save", ""});
    return false;
  }
  const QString stem = document.isScratch() ? tr("calibration") : document.displayName();
  const QString file = m_prompts->askSaveFile(this, folderForDialogs() + "/" + stem + ".sedge");
  return !file.isEmpty() && saveTo(file);
}

bool MainWindow::saveTo(const QString& file) {
  if (auto saved = m_workspace->document().saveAs(file); !saved) {
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
  auto& document = m_workspace->document();
  if (!document.isOpen()) {
    return true;
  }
  if (m_workspace->isCapturing()) {
    if (!m_prompts->confirmStopCapture(this)) {
      return false;
    }
    m_workspace->stopAndWait();
  }
  if (document.isScratch() && document.hasContent()) {
    switch (m_prompts->askClose(this)) {
    case WindowPrompts::CloseAnswer::Cancel:
      return false;
    case WindowPrompts::CloseAnswer::Save:
      if (!saveAs()) {
        return false;
      }
      break;
    case WindowPrompts::CloseAnswer::Discard:
      if (auto gone = document.discard(); !gone) {
        complain(gone.error());
      }
      return true;
    case WindowPrompts::CloseAnswer::KeepForLater:
      break;
    }
  } else if (document.isReadOnly() && document.hasUnsavedState()) {
    if (!m_prompts->confirmLoss(this, tr("The file is on read-only media. “Save As” keeps the changes elsewhere."))) {
      return false;
    }
    static_cast<void>(document.discard()); // read-only: there is nothing to write
    return true;
  }
  if (auto closed = document.close(); !closed) {
    if (document.isOpen()) {
      if (!m_prompts->confirmLoss(this, QString::fromStdString(closed.error().message()))) {
        complain(closed.error());
        return false;
      }
      static_cast<void>(document.abandon());
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
