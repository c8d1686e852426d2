// Inside of AngleDocument: not for other folders.
#pragma once

#include "app/gui/document/angle_document.h"
#include "app/gui/document/recompute.h"
#include "app/gui/document/session_binding.h"

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
  Impl(AngleDocument& owner, JobRunner& jobs) : document(owner), recompute(jobs), binding(owner.binding()) {}

  AngleDocument& document;
  Recompute recompute;
  SessionBinding& binding;

  SweepState calibration;
  std::shared_ptr<const angle::Sweep> verification = std::make_shared<const angle::Sweep>();
  AngleChoices choices;
  devices::AnglePlan plan;
  std::string keptRun;          ///< calibration.json as the session has it; empty where there is none
  std::string keptVerification; ///< likewise the fresh sweep's result

  void updateRecompute();
  void scheduleReview();
  void scheduleVerificationSweep();
  void keepRun(); ///< into the session, where it differs from what is there
  void keepVerification();
  bool choicesAreDefault() const;
  SweepState sweepOf(const session::Session& session, QStringList& problems) const;

  // What undo and redo put in place
  void applySweep(const SweepState& state);
  void applyEnabled(const std::shared_ptr<const angle::Sweep>& sweep);
  void applyChoices(const AngleChoices& value);
  void applyPlan(const devices::AnglePlan& value);
};

} // namespace straightedge::gui
