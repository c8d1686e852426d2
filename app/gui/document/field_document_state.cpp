#include "app/gui/document/field_document_state.h"

#include "app/gui/document/document_json.h"
#include "app/gui/document/document_reading.h"
#include "app/gui/document/field_document_json.h"
#include "core/export/field_calibration_json.h"
#include "core/field/session_campaign.h"

#include <utility>

namespace straightedge::gui {

void FieldDocument::reset() {
  m_impl->calibration = {};
  m_impl->verification = std::make_shared<const field::Campaign>();
  m_impl->choices = {};
  m_impl->plan = devices::makeFieldPlan();
  m_impl->keptRun.clear();
  m_impl->recompute.clear();
}

void FieldDocument::inputsChanged() { m_impl->updateRecompute(); }

bool FieldDocument::holdsContent() const {
  if (!m_impl->calibration.campaign->rows.empty() || !m_impl->verification->rows.empty() ||
      m_impl->choices != FieldChoices{}) {
    return true;
  }
  const auto* open = session();
  if (open == nullptr) {
    return false;
  }
  // A count that cannot be read is no proof of emptiness.
  const auto samples = open->fieldSampleCount(session::SweepRole::Calibration);
  const auto fresh = open->fieldSampleCount(session::SweepRole::Verification);
  return !samples || !fresh || *samples > 0 || *fresh > 0;
}

QStringList FieldDocument::load(session::Session& session) {
  QStringList problems;
  const auto read = [&](const char* name, auto parse, auto take) {
    readDocument(session, name, problems, parse, take);
  };
  auto& state = *m_impl;
  state.choices = {};
  state.plan = devices::makeFieldPlan();
  state.verification = std::make_shared<const field::Campaign>();
  read(
      fieldChoicesDocument, [](const std::string& text) { return fieldChoicesFromJson(text); },
      [&](FieldChoices value) { state.choices = std::move(value); });
  read(
      planDocument, [](const std::string& text) { return devices::fieldPlanFromJson(text); },
      [&](devices::FieldPlan value) { state.plan = std::move(value); });
  state.calibration = state.campaignOf(session, problems);
  read(
      reviewDocument, [](const std::string& text) { return reviewFromJson(text); },
      [&](const std::vector<std::size_t>& rows) {
        auto enabled = std::make_shared<std::vector<bool>>(*state.calibration.enabled);
        for (const std::size_t row : rows) {
          if (row < enabled->size()) {
            (*enabled)[row] = false;
          }
        }
        state.calibration.enabled = std::move(enabled);
      });
  state.keptRun.clear();
  read(resultDocument, asItIs, [&](std::string text) { state.keptRun = std::move(text); });
  bool imported = false;
  read(
      verificationCampaignDocument, [](const std::string& text) { return campaignFromJson(text); },
      [&](field::Campaign value) {
        imported = true;
        state.verification = std::make_shared<const field::Campaign>(std::move(value));
      });
  if (!imported) {
    state.verification = state.captured(session, session::SweepRole::Verification, problems);
  }
  return problems;
}

CampaignState FieldDocument::Impl::campaignOf(const session::Session& session, QStringList& problems) const {
  CampaignState state;
  const auto take = [&](std::shared_ptr<const field::Campaign> campaign, CampaignOrigin origin) {
    state.enabled = std::make_shared<const std::vector<bool>>(campaign->rows.size(), true);
    state.campaign = std::move(campaign);
    state.origin = origin;
  };
  readDocument(
      session, importedCampaignDocument, problems, [](const std::string& text) { return campaignFromJson(text); },
      [&](field::Campaign value) {
        take(std::make_shared<const field::Campaign>(std::move(value)), CampaignOrigin::Imported);
      });
  if (state.origin == CampaignOrigin::None) {
    auto recorded = captured(session, session::SweepRole::Calibration, problems);
    if (!recorded->rows.empty()) {
      take(std::move(recorded), CampaignOrigin::Captured);
    }
  }
  return state;
}

std::shared_ptr<const field::Campaign>
FieldDocument::Impl::captured(const session::Session& session, session::SweepRole role, QStringList& problems) const {
  const auto samples = session.fieldSamples(role);
  if (!samples) {
    problems.append(QString::fromStdString(samples.error().message()));
    return std::make_shared<const field::Campaign>();
  }
  auto campaign = field::campaignFromSamples(*samples, session.file().filename().string());
  if (!campaign) {
    problems.append(QString::fromStdString(campaign.error().message()));
    return std::make_shared<const field::Campaign>();
  }
  campaign->name.clear(); // the session's, under whatever name it is kept when a result is made
  return std::make_shared<const field::Campaign>(std::move(*campaign));
}

void FieldDocument::Impl::updateRecompute() {
  recompute.setInputs({calibration.campaign, calibration.enabled, verification, choices, document.traceability(),
                       displayedFileName(document.file())});
}

void FieldDocument::Impl::scheduleReview() {
  binding.schedule(reviewDocument, [enabled = calibration.enabled](session::Session& session) {
    return session.setDocument(reviewDocument, switchedOffToJson(*enabled));
  });
}

void FieldDocument::Impl::scheduleVerificationCampaign(bool imported) {
  binding.schedule(verificationCampaignDocument, [imported, campaign = verification](session::Session& session) {
    return session.setDocument(verificationCampaignDocument,
                               imported && !campaign->rows.empty() ? campaignToJson(*campaign) : std::string());
  });
}

void FieldDocument::Impl::keepRun() {
  std::string text;
  if (recompute.run) {
    field::FieldCalibration result = recompute.run->result;
    // Opening a file computes anew what it already says: that is no new result, and no reason to touch the file.
    if (const auto kept = exporting::fieldCalibrationFromJson(keptRun, displayedFileName(document.file())); kept) {
      const std::string now = std::exchange(result.created, kept->created);
      if (exporting::fieldCalibrationToJson(result) == keptRun) {
        return;
      }
      result.created = now;
    }
    text = exporting::fieldCalibrationToJson(result);
  }
  if (text == keptRun) {
    return;
  }
  keptRun = text;
  binding.schedule(resultDocument,
                   [text](session::Session& session) { return session.setDocument(resultDocument, text); });
}

void FieldDocument::Impl::applyCampaign(const CampaignState& state) {
  calibration = state;
  binding.schedule(importedCampaignDocument, [state](session::Session& session) {
    return session.setDocument(importedCampaignDocument, state.origin == CampaignOrigin::Imported
                                                             ? campaignToJson(*state.campaign)
                                                             : std::string());
  });
  scheduleReview();
  updateRecompute();
  emit document.campaignChanged();
}

void FieldDocument::Impl::applyEnabled(const std::shared_ptr<const std::vector<bool>>& enabled) {
  calibration.enabled = enabled;
  scheduleReview();
  updateRecompute();
  emit document.campaignChanged();
}

void FieldDocument::Impl::applyChoices(const FieldChoices& value) {
  choices = value;
  binding.schedule(fieldChoicesDocument, [value](session::Session& session) {
    return session.setDocument(fieldChoicesDocument, fieldChoicesToJson(value));
  });
  updateRecompute();
  emit document.choicesChanged();
}

void FieldDocument::Impl::applyPlan(const devices::FieldPlan& value) {
  plan = value;
  binding.schedule(planDocument, [value](session::Session& session) {
    return session.setDocument(planDocument, devices::planToJson(value));
  });
  emit document.planChanged();
}

} // namespace straightedge::gui
