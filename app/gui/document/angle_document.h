// The open angle calibration as the window sees it: session file, sweep, choices and what was computed from them.
#pragma once

#include "core/angle/calibration.h"
#include "core/angle/comparison.h"
#include "core/angle/verification.h"
#include "core/session/session.h"
#include "devices/capture/angle_plan.h"

#include <QObject>
#include <QString>
#include <QUndoStack>

#include <memory>
#include <optional>
#include <vector>

namespace straightedge::gui {

class JobRunner;

/// What the engineer chose; every change goes through the undo stack and into the session.
struct AngleChoices {
  angle::CurveMethod curveMethod = angle::CurveMethod::Auto;
  std::vector<angle::ModelName> models = angle::defaultModels(); ///< shown in Fit, written by Export
  angle::ModelName selected = angle::defaultModels().front();    ///< the one that Verify uses and Compare highlights
  double targetErrorDeg = 0.5;
  int budgetEntries = 64;
  std::optional<int> bits; ///< quantisation in Compare
  double limitDeg = 1.0;   ///< Verify

  bool operator==(const AngleChoices&) const = default;
};

/// GUI thread. Recomputes in jobs: sweep or choices change -> calibrate -> compare (quick, then fully); each result
/// arrives with its signal. While a job runs the previous results stay visible. Everything is kept in the session file
/// as it changes; a new calibration lives in a scratch file until it is saved under a name.
class AngleDocument : public QObject {
  Q_OBJECT
public:
  explicit AngleDocument(JobRunner& jobs, QObject* parent = nullptr);
  ~AngleDocument() override;

  // Life
  Result<void> createScratch(); ///< a new, unnamed session
  /// Whether open() would take the file; nothing that is open is touched. Errors: those of open().
  static Result<void> probe(const QString& file);
  Result<void> open(const QString& file); ///< a file of the scratch folder is recovered: it stays unnamed
  Result<void> saveAs(const QString& file);
  /// Commits and checkpoints. A scratch file with content stays and can be opened again ("keep for later"); an empty
  /// one is removed. Where something cannot be written the document stays open.
  Result<void> close();
  Result<void> abandon(); ///< closes without writing what is pending; the file stays as it is
  Result<void> discard(); ///< closes without writing what is pending; a scratch file is removed
  bool isOpen() const;
  bool isScratch() const;       ///< not saved under a name yet
  bool hasContent() const;      ///< samples, an imported sweep, or anything chosen or undone
  bool isReadOnly() const;      ///< on read-only media: changes last only until saved elsewhere
  bool hasUnsavedState() const; ///< scratch with content, or a write still pending or failed
  QString file() const;
  QString displayName() const; ///< "Untitled" or the file's base name
  session::Session* session();

  // Sweep
  const angle::Sweep& sweep() const;                          ///< the calibration sweep; empty where there is none yet
  void setSweep(angle::Sweep sweep, const QString& undoText); ///< imported data replace the sweep (undoable)
  void reloadSweepFromSession(); ///< after capture: samples -> sweep (latest attempt of every point)
  void setPointsEnabled(const std::vector<std::size_t>& rows, bool enabled); ///< undoable
  const angle::Sweep& verificationSweep() const;
  void setVerificationSweep(angle::Sweep sweep);

  // Choices
  const AngleChoices& choices() const;
  void setChoices(const AngleChoices& choices,
                  const QString& undoText); ///< undoable; equal text in a row merges (drags)
  const Traceability& traceability() const;
  void setTraceability(const Traceability& traceability); ///< undoable
  const devices::AnglePlan& plan() const;
  void setPlan(const devices::AnglePlan& plan); ///< undoable

  // Results: null or empty until computed, and while the data are refused
  std::shared_ptr<const angle::CalibrationRun> run() const;
  const std::optional<Error>& runError() const; ///< why the sweep was refused
  std::shared_ptr<const angle::Comparison> comparison() const;
  bool comparisonComplete() const; ///< minimax and fine grid are in
  const std::optional<angle::VerificationReport>& verification() const;
  const std::optional<Error>& verificationError() const;

  QUndoStack& undoStack();

signals:
  void opened(); ///< another calibration, or none: read everything anew
  void titleChanged();
  void sweepChanged();
  void choicesChanged();
  void traceabilityChanged();
  void planChanged();
  void runChanged();
  void comparisonChanged();
  void verificationSweepChanged();
  void verificationChanged();
  void storageFailed(const QString& message); ///< shown by the window; the document goes on

private:
  struct Impl;
  std::unique_ptr<Impl> m_impl;
};

} // namespace straightedge::gui
