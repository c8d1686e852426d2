#include "app/gui/shell/window_prompts.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QMessageBox>
#include <QPushButton>

namespace straightedge::gui {

namespace {

QString sayPrompt(const char* text) { return QCoreApplication::translate("WindowPrompts", text); }

/// Two answers, the harmless one as default and on Escape.
bool confirm(QWidget* parent, const QString& question, const QString& detail, const QString& yes) {
  QMessageBox box(QMessageBox::Warning, sayPrompt("Straightedge"), question, QMessageBox::NoButton, parent);
  box.setInformativeText(detail);
  auto* go = box.addButton(yes, QMessageBox::DestructiveRole);
  auto* cancel = box.addButton(QMessageBox::Cancel);
  box.setDefaultButton(cancel);
  box.setEscapeButton(cancel);
  box.exec();
  return box.clickedButton() == go;
}

} // namespace

WindowPrompts::CloseAnswer DialogPrompts::askClose(QWidget* parent) {
  QMessageBox box(QMessageBox::Question, sayPrompt("Straightedge"), sayPrompt("Save this calibration under a name?"),
                  QMessageBox::NoButton, parent);
  box.setInformativeText(
      sayPrompt("It can also be kept as it is: the start page then offers it under “Unsaved calibrations”."));
  auto* save = box.addButton(sayPrompt("&Save…"), QMessageBox::AcceptRole);
  auto* keep = box.addButton(sayPrompt("&Keep for later"), QMessageBox::AcceptRole);
  auto* discard = box.addButton(sayPrompt("&Discard"), QMessageBox::DestructiveRole);
  auto* cancel = box.addButton(QMessageBox::Cancel);
  box.setDefaultButton(save);
  box.setEscapeButton(cancel);
  box.exec();
  const auto* clicked = box.clickedButton();
  if (clicked == save) {
    return CloseAnswer::Save;
  }
  if (clicked == keep) {
    return CloseAnswer::KeepForLater;
  }
  if (clicked == discard && confirm(parent, sayPrompt("Discard this calibration for good?"),
                                    sayPrompt("Its samples and choices are deleted."), sayPrompt("&Discard"))) {
    return CloseAnswer::Discard;
  }
  return CloseAnswer::Cancel;
}

bool DialogPrompts::confirmStopCapture(QWidget* parent) {
  return confirm(parent, sayPrompt("A capture is running. Stop it?"),
                 sayPrompt("What was captured so far stays in the session, and the sweep can be resumed."),
                 sayPrompt("&Stop capture"));
}

bool DialogPrompts::confirmLoss(QWidget* parent, const QString& problem) {
  return confirm(parent, sayPrompt("The last changes cannot be written. Close all the same?"), problem,
                 sayPrompt("Close and &lose them"));
}

bool DialogPrompts::confirmDelete(QWidget* parent, const QString& what) {
  return confirm(parent, sayPrompt("Delete this unsaved calibration?"), what, sayPrompt("&Delete"));
}

QString DialogPrompts::askOpenFile(QWidget* parent, const QString& folder) {
  return QFileDialog::getOpenFileName(parent, sayPrompt("Open"), folder,
                                      sayPrompt("Calibrations, sweeps and campaigns (*.sedge *.csv *.tsv *.txt);;"
                                                "Calibrations (*.sedge);;Sweeps and campaigns (*.csv *.tsv *.txt);;"
                                                "All files (*)"));
}

QString DialogPrompts::askSaveFile(QWidget* parent, const QString& suggestion) {
  // Not getSaveFileName(): the suffix must be there before the dialogue asks about overwriting.
  QFileDialog dialog(parent, sayPrompt("Save calibration as"), suggestion, sayPrompt("Calibrations (*.sedge)"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix("sedge");
  dialog.selectFile(suggestion);
  return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

QString DialogPrompts::askCsvFile(QWidget* parent, const QString& folder) {
  return QFileDialog::getOpenFileName(parent, sayPrompt("Import sweep or campaign"), folder,
                                      sayPrompt("Sweeps and campaigns (*.csv *.tsv *.txt);;All files (*)"));
}

} // namespace straightedge::gui
