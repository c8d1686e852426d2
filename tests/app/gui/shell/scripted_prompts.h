// Answers to the window's questions, given before they are asked, and a count of what was asked.
#pragma once

#include "app/gui/shell/window_prompts.h"

#include <QList>

namespace straightedge::gui {

/// Shared between the test and the prompts that the window owns.
struct PromptScript {
  WindowPrompts::CloseAnswer closeAnswer = WindowPrompts::CloseAnswer::Cancel;
  bool stopCapture = true;
  bool acceptLoss = false;
  bool deleteIt = true;
  QString openFile, saveFile, csvFile;
  int closeAsked = 0;
  int stopAsked = 0;
  int lossAsked = 0;
  int deleteAsked = 0;
};

class ScriptedPrompts : public WindowPrompts {
public:
  explicit ScriptedPrompts(PromptScript& script) : m_script(script) {}
  CloseAnswer askClose(QWidget*) override {
    ++m_script.closeAsked;
    return m_script.closeAnswer;
  }
  bool confirmStopCapture(QWidget*) override {
    ++m_script.stopAsked;
    return m_script.stopCapture;
  }
  bool confirmLoss(QWidget*, const QString&) override {
    ++m_script.lossAsked;
    return m_script.acceptLoss;
  }
  bool confirmDelete(QWidget*, const QString&) override {
    ++m_script.deleteAsked;
    return m_script.deleteIt;
  }
  QString askOpenFile(QWidget*, const QString&) override { return m_script.openFile; }
  QString askSaveFile(QWidget*, const QString&) override { return m_script.saveFile; }
  QString askCsvFile(QWidget*, const QString&) override { return m_script.csvFile; }

private:
  PromptScript& m_script;
};

} // namespace straightedge::gui
