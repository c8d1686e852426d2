// Inside of FieldDocument: not for other folders.
#pragma once

#include "app/gui/document/field_document.h"
#include "app/gui/document/field_recompute.h"
#include "app/gui/document/session_binding.h"

#include <memory>
#include <string>
#include <vector>

namespace straightedge::gui {

/// Where the campaign came from: it decides what the session has to keep.
enum class CampaignOrigin : std::uint8_t { None, Captured, Imported };

/// A campaign in force, and which of its rows count.
struct CampaignState {
  std::shared_ptr<const field::Campaign> campaign = std::make_shared<const field::Campaign>();
  std::shared_ptr<const std::vector<bool>> enabled = std::make_shared<const std::vector<bool>>();
  CampaignOrigin origin = CampaignOrigin::None;
};

struct FieldDocument::Impl {
  Impl(FieldDocument& owner, JobRunner& jobs) : document(owner), recompute(jobs), binding(owner.binding()) {}

  FieldDocument& document;
  FieldRecompute recompute;
  SessionBinding& binding;

  CampaignState calibration;
  std::shared_ptr<const field::Campaign> verification = std::make_shared<const field::Campaign>();
  FieldChoices choices;
  devices::FieldPlan plan = devices::makeFieldPlan();
  std::string keptRun; ///< calibration.json as the session has it; empty where there is none

  void updateRecompute();
  void scheduleReview();
  void scheduleVerificationCampaign(bool imported);
  void keepRun(); ///< into the session, where it differs from what is there
  CampaignState campaignOf(const session::Session& session, QStringList& problems) const;
  std::shared_ptr<const field::Campaign> captured(const session::Session& session, session::SweepRole role,
                                                  QStringList& problems) const;

  // What undo and redo put in place
  void applyCampaign(const CampaignState& state);
  void applyEnabled(const std::shared_ptr<const std::vector<bool>>& enabled);
  void applyChoices(const FieldChoices& value);
  void applyPlan(const devices::FieldPlan& value);
};

} // namespace straightedge::gui
