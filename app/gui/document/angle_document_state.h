// Inside of AngleDocument: not for other folders.
#pragma once

#include "app/gui/document/angle_document.h"
#include "app/gui/document/recompute.h"
#include "app/gui/document/session_binding.h"

#include <QLockFile>

#include <memory>

namespace straightedge::gui {

/// Where the calibration sweep came from: it decides what the session has to keep.
enum class SweepOrigin : std::uint8_t { None, Captured, Imported };

/// A sweep in force. Shared and never changed: undo, jobs and the window hold on to the same one.
struct SweepState {
  std::shared_ptr<const angle::Sweep> sweep = std::make_shared<const angle::Sweep>();
  SweepOrigin origin = SweepOrigin::None;
};

struct AngleDocument::Impl {
  Impl(AngleDocument& owner, JobRunner& jobs) : document(owner), recompute(jobs) {}

  AngleDocument& document;
  Recompute recompute;
  SessionBinding binding;
  QUndoStack undo;
  QString file;
  std::unique_ptr<QLockFile> scratchLock; ///< set while the session is a scratch file

  SweepState calibration;
  std::shared_ptr<const angle::Sweep> verification = std::make_shared<const angle::Sweep>();
  AngleChoices choices;
  Traceability traceability;
  devices::AnglePlan plan;
  std::string keptRun;          ///< calibration.json as the session has it; empty where there is none
  std::string keptVerification; ///< likewise the fresh sweep's result

  void adopt(std::unique_ptr<session::Session> session, const QString& name, std::unique_ptr<QLockFile> lock);
  QStringList load(session::Session& session); ///< returns what could not be read, in sentences
  void reset();
  void updateRecompute();
  void scheduleReview();
  void scheduleVerificationSweep();
  void keepRun(); ///< into the session, where it differs from what is there
  void keepVerification();
  bool choicesAreDefault() const;
  SweepState sweepOf(session::Session& session, QStringList& problems) const;

  // What undo and redo put in place
  void applySweep(const SweepState& state);
  void applyEnabled(const std::shared_ptr<const angle::Sweep>& sweep);
  void applyChoices(const AngleChoices& value);
  void applyTraceability(const Traceability& value);
  void applyPlan(const devices::AnglePlan& value);
};

} // namespace straightedge::gui
