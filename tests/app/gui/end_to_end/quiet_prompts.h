// Answers the window's questions without dialogues: nothing is kept, every risk is taken.
#pragma once

#include "app/gui/shell/window_prompts.h"

namespace straightedge::gui {

class QuietPrompts : public WindowPrompts {
public:
  CloseAnswer askClose(QWidget*) override { return CloseAnswer::Discard; }
  bool confirmStopCapture(QWidget*) override { return true; }
  bool confirmLoss(QWidget*, const QString&) override { return true; }
  bool confirmDelete(QWidget*, const QString&) override { return true; }
  QString askOpenFile(QWidget*, const QString&) override { return {}; }
  QString askSaveFile(QWidget*, const QString&) override { return {}; }
  QString askCsvFile(QWidget*, const QString&) override { return {}; }
};

} // namespace straightedge::gui
