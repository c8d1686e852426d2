// What the window needs from a kind of calibration: its document, its steps, and what files of data become.
#pragma once

#include "app/gui/document/calibration_document.h"
#include "app/gui/shell/reference_unit.h"
#include "app/gui/shell/step_entry.h"
#include "app/gui/steps/step_page.h"

#include <QObject>
#include <QString>

#include <functional>
#include <span>
#include <string>

namespace straightedge::gui {

/// Where data are looked at after they were put into a calibration, and what the status line says of them.
struct Landing {
  int step = 0;
  QString text;
};

/// Data that were read and wait for a calibration of their kind to be open.
struct ReadyData {
  QString file;                 ///< where they came from; empty for what is part of the program
  std::function<Landing()> put; ///< into document(), which is open then
};

/// GUI thread. The window holds one for each kind that was needed so far, and at most one of them has its document
/// open.
class Workspace : public QObject {
  Q_OBJECT
public:
  explicit Workspace(QObject* parent = nullptr) : QObject(parent) {}

  virtual CalibrationDocument& document() = 0;

  virtual std::span<const StepEntry> steps() const = 0;
  virtual StepState state(std::size_t step) const = 0; ///< from the calibration and the bench: pages need not exist
  virtual StepPage* makePage(std::size_t step, QWidget* parent) = 0;
  virtual int firstStepAfterOpening() const = 0; ///< Review where there are data, else Connect

  virtual bool isCapturing() const = 0;
  virtual void stopAndWait() = 0; ///< ends a capture, commits, and returns when both are done

  /// Reads a file of data in jobs, with a preview over `window` where columns have to be understood first. Ends with
  /// dataReady() or failed(), or with nothing where the user cancels. `currentStep` is −1 on the start page.
  virtual void importFile(const QString& file, int currentStep, QWidget& window) = 0;
  /// The same for an example that is part of the program, at once.
  virtual Result<ReadyData> readExample(std::string bytes, const QString& name) = 0;
  virtual ReferenceUnit referenceUnit() const = 0; ///< for the details

signals:
  void stateChanged(); ///< state(), isCapturing() or the document's title
  void dataReady(const straightedge::gui::ReadyData& data);
  void failed(const QString& message);
  void benchFailed(const QString& message); ///< the shown page may say so itself (StepPage::tellsBenchFaults)
};

/// −1 where no step has that title.
int stepIndex(std::span<const StepEntry> steps, const QString& title);

} // namespace straightedge::gui
