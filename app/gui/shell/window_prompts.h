// The questions the window asks, behind an interface so that tests answer them without dialogues.
#pragma once

#include <QString>

#include <cstdint>

class QWidget;

namespace straightedge::gui {

class WindowPrompts {
public:
  enum class CloseAnswer : std::uint8_t { Save, KeepForLater, Discard, Cancel };

  virtual ~WindowPrompts() = default;
  virtual CloseAnswer askClose(QWidget* parent) = 0;
  virtual bool confirmStopCapture(QWidget* parent) = 0;
  /// The open session cannot be written: close all the same?
  virtual bool confirmLoss(QWidget* parent, const QString& problem) = 0;
  virtual bool confirmDelete(QWidget* parent, const QString& what) = 0;
  // File names; empty = cancelled
  virtual QString askOpenFile(QWidget* parent, const QString& folder) = 0;
  virtual QString askSaveFile(QWidget* parent, const QString& suggestion) = 0;
  virtual QString askCsvFile(QWidget* parent, const QString& folder) = 0;
};

/// Message boxes and the desktop's file dialogues.
class DialogPrompts : public WindowPrompts {
public:
  CloseAnswer askClose(QWidget* parent) override;
  bool confirmStopCapture(QWidget* parent) override;
  bool confirmLoss(QWidget* parent, const QString& problem) override;
  bool confirmDelete(QWidget* parent, const QString& what) override;
  QString askOpenFile(QWidget* parent, const QString& folder) override;
  QString askSaveFile(QWidget* parent, const QString& suggestion) override;
  QString askCsvFile(QWidget* parent, const QString& folder) override;
};

} // namespace straightedge::gui
