#include "app/gui/document/angle_document_state.h"

#include "app/gui/document/captured_sweep.h"
#include "app/gui/document/document_json.h"
#include "app/gui/document/document_reading.h"
#include "core/export/calibration_json.h"
#include "core/export/verification_json.h"

#include <utility>

namespace straightedge::gui {

namespace {
QString sentence(const Error& error) { return QString::fromStdString(error.message()); }
} // namespace

void AngleDocument::reset() {
  m_impl->calibration = {};
  m_impl->verification = std::make_shared<const angle::Sweep>();
  m_impl->choices = {};
  m_impl->plan = {};
  m_impl->keptRun.clear();
  m_impl->keptVerification.clear();
  m_impl->recompute.clear();
}

void AngleDocument::inputsChanged() { m_impl->updateRecompute(); }

bool AngleDocument::holdsContent() const {
  if (m_impl->calibration.sweep->size() > 0 || m_impl->verification->size() > 0 || !m_impl->choicesAreDefault()) {
    return true;
  }
  const auto* open = session();
  if (open == nullptr) {
    return false;
  }
  // A count that cannot be read is no proof of emptiness.
  const auto samples = open->angleSampleCount(session::SweepRole::Calibration);
  const auto fresh = open->angleSampleCount(session::SweepRole::Verification);
  return !samples || !fresh || *samples > 0 || *fresh > 0;
}

QStringList AngleDocument::load(session::Session& session) {
  QStringList problems;
  const auto read = [&](const char* name, auto parse, auto take) {
    readDocument(session, name, problems, parse, take);
  };
  auto& state = *m_impl;
  state.choices = {};
  state.plan = {};
  state.verification = std::make_shared<const angle::Sweep>();
  read(
      choicesDocument, [](const std::string& text) { return choicesFromJson(text); },
      [&](AngleChoices value) { state.choices = std::move(value); });
  read(
      planDocument, [](const std::string& text) { return devices::planFromJson(text); },
      [&](devices::AnglePlan value) { state.plan = value; });
  state.calibration = state.sweepOf(session, problems);
  read(
      reviewDocument, [](const std::string& text) { return reviewFromJson(text); },
      [&](const std::vector<std::size_t>& rows) {
        auto reviewed = std::make_shared<angle::Sweep>(*state.calibration.sweep);
        for (const std::size_t row : rows) {
          if (row < reviewed->size()) {
            reviewed->enabled.resize(reviewed->size(), true);
            reviewed->enabled[row] = false;
          }
        }
        state.calibration.sweep = std::move(reviewed);
      });
  state.keptRun.clear();
  state.keptVerification.clear();
  read(resultDocument, asItIs, [&](std::string text) { state.keptRun = std::move(text); });
  read(verificationResultDocument, asItIs, [&](std::string text) { state.keptVerification = std::move(text); });
  bool imported = false;
  read(
      verificationSweepDocument, [](const std::string& text) { return sweepFromJson(text); },
      [&](angle::Sweep value) {
        imported = true;
        state.verification = std::make_shared<const angle::Sweep>(std::move(value));
      });
  if (!imported) {
    if (const auto samples = session.angleSamples(session::SweepRole::Verification); samples && !samples->empty()) {
      state.verification = std::make_shared<const angle::Sweep>(capturedSweep(*samples));
    }
  }
  return problems;
}

SweepState AngleDocument::Impl::sweepOf(const session::Session& session, QStringList& problems) const {
  const auto imported = session.document(importedSweepDocument);
  if (imported && !imported->empty()) {
    auto sweep = sweepFromJson(*imported);
    if (sweep) {
      return {std::make_shared<const angle::Sweep>(std::move(*sweep)), SweepOrigin::Imported};
    }
    problems.append(sentence(sweep.error()));
  } else if (!imported) {
    problems.append(sentence(imported.error()));
  }
  const auto samples = session.angleSamples(session::SweepRole::Calibration);
  if (!samples) {
    problems.append(sentence(samples.error()));
    return {};
  }
  if (samples->empty()) {
    return {};
  }
  return {std::make_shared<const angle::Sweep>(capturedSweep(*samples)), SweepOrigin::Captured};
}

bool AngleDocument::Impl::choicesAreDefault() const { return choices == AngleChoices{}; }

void AngleDocument::Impl::updateRecompute() {
  recompute.setInputs(
      {calibration.sweep, verification, choices, document.traceability(), displayedFileName(document.file())});
}

void AngleDocument::Impl::scheduleReview() {
  binding.schedule(reviewDocument, [sweep = calibration.sweep](session::Session& session) {
    return session.setDocument(reviewDocument, reviewToJson(*sweep));
  });
}

void AngleDocument::Impl::scheduleVerificationSweep() {
  binding.schedule(verificationSweepDocument, [sweep = verification](session::Session& session) {
    return session.setDocument(verificationSweepDocument, sweep->size() == 0 ? "" : sweepToJson(*sweep));
  });
}

void AngleDocument::Impl::keepRun() {
  std::string text;
  if (recompute.run) {
    angle::AngleCalibration result = recompute.run->result;
    // Opening a file computes anew what it already says: that is no new result, and no reason to touch the file.
    if (const auto kept = exporting::calibrationFromJson(keptRun, displayedFileName(document.file())); kept) {
      const std::string now = std::exchange(result.created, kept->created);
      if (exporting::calibrationToJson(result) == keptRun) {
        return;
      }
      result.created = now;
    }
    text = exporting::calibrationToJson(result);
  }
  if (text == keptRun) {
    return;
  }
  keptRun = text;
  binding.schedule(resultDocument,
                   [text](session::Session& session) { return session.setDocument(resultDocument, text); });
}

void AngleDocument::Impl::keepVerification() {
  std::string text;
  if (recompute.verification) {
    text = exporting::verificationToJson(*recompute.verification, document.traceability(), verification->source);
  }
  if (text == keptVerification) {
    return;
  }
  keptVerification = text;
  binding.schedule(verificationResultDocument,
                   [text](session::Session& session) { return session.setDocument(verificationResultDocument, text); });
}

void AngleDocument::Impl::applySweep(const SweepState& state) {
  calibration = state;
  binding.schedule(importedSweepDocument, [state](session::Session& session) {
    return session.setDocument(importedSweepDocument,
                               state.origin == SweepOrigin::Imported ? sweepToJson(*state.sweep) : std::string());
  });
  scheduleReview();
  updateRecompute();
  emit document.sweepChanged();
}

void AngleDocument::Impl::applyEnabled(const std::shared_ptr<const angle::Sweep>& sweep) {
  calibration.sweep = sweep;
  scheduleReview();
  updateRecompute();
  emit document.sweepChanged();
}

void AngleDocument::Impl::applyChoices(const AngleChoices& value) {
  choices = value;
  binding.schedule(choicesDocument, [value](session::Session& session) {
    return session.setDocument(choicesDocument, choicesToJson(value));
  });
  updateRecompute();
  emit document.choicesChanged();
}

void AngleDocument::Impl::applyPlan(const devices::AnglePlan& value) {
  plan = value;
  binding.schedule(planDocument, [value](session::Session& session) {
    return session.setDocument(planDocument, devices::planToJson(value));
  });
  emit document.planChanged();
}

} // namespace straightedge::gui
