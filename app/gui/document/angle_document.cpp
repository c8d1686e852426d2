#include "app/gui/document/angle_document.h"

#include "app/gui/document/angle_document_state.h"
#include "app/gui/document/captured_sweep.h"
#include "app/gui/document/undo_commands.h"

#include <utility>

namespace straightedge::gui {

AngleDocument::AngleDocument(JobRunner& jobs, QObject* parent)
    : CalibrationDocument(parent), m_impl(std::make_unique<Impl>(*this, jobs)) {
  connect(&m_impl->recompute, &Recompute::runChanged, this, [this] { m_impl->keepRun(); });
  connect(&m_impl->recompute, &Recompute::verificationChanged, this, [this] { m_impl->keepVerification(); });
  connect(&m_impl->recompute, &Recompute::runChanged, this, &AngleDocument::runChanged);
  connect(&m_impl->recompute, &Recompute::comparisonChanged, this, &AngleDocument::comparisonChanged);
  connect(&m_impl->recompute, &Recompute::verificationChanged, this, &AngleDocument::verificationChanged);
}

AngleDocument::~AngleDocument() { endLife(); }

const angle::Sweep& AngleDocument::sweep() const { return *m_impl->calibration.sweep; }

const angle::Sweep& AngleDocument::verificationSweep() const { return *m_impl->verification; }

const AngleChoices& AngleDocument::choices() const { return m_impl->choices; }

const devices::AnglePlan& AngleDocument::plan() const { return m_impl->plan; }

std::shared_ptr<const angle::CalibrationRun> AngleDocument::run() const { return m_impl->recompute.run; }

const std::optional<Error>& AngleDocument::runError() const { return m_impl->recompute.runError; }

std::shared_ptr<const angle::Comparison> AngleDocument::comparison() const { return m_impl->recompute.comparison; }

bool AngleDocument::comparisonComplete() const { return m_impl->recompute.comparisonComplete; }

const std::optional<angle::VerificationReport>& AngleDocument::verification() const {
  return m_impl->recompute.verification;
}

const std::optional<Error>& AngleDocument::verificationError() const { return m_impl->recompute.verificationError; }

void AngleDocument::setSweep(angle::Sweep sweep, const QString& undoText) {
  SweepState after{std::make_shared<const angle::Sweep>(std::move(sweep)), SweepOrigin::Imported};
  undoStack().push(
      new ChangeCommand<SweepState>(undoText, m_impl->calibration, std::move(after), UndoMerge::Never,
                                    [impl = m_impl.get()](const SweepState& state) { impl->applySweep(state); }));
}

void AngleDocument::setPointsEnabled(const std::vector<std::size_t>& rows, bool enabled) {
  auto changed = std::make_shared<angle::Sweep>(sweep());
  changed->enabled.resize(changed->size(), true);
  bool any = false;
  for (const std::size_t row : rows) {
    if (row < changed->size() && changed->enabled[row] != enabled) {
      changed->enabled[row] = enabled;
      any = true;
    }
  }
  if (!any) {
    return;
  }
  using Shared = std::shared_ptr<const angle::Sweep>;
  const auto count = static_cast<int>(rows.size());
  const QString text =
      enabled ? tr("switch on %n point(s)", nullptr, count) : tr("switch off %n point(s)", nullptr, count);
  undoStack().push(
      new ChangeCommand<Shared>(text, m_impl->calibration.sweep, std::move(changed), UndoMerge::Never,
                                [impl = m_impl.get()](const Shared& value) { impl->applyEnabled(value); }));
}

void AngleDocument::setChoices(const AngleChoices& choices, const QString& undoText) {
  if (choices == m_impl->choices) {
    return;
  }
  undoStack().push(
      new ChangeCommand<AngleChoices>(undoText, m_impl->choices, choices, UndoMerge::Choices,
                                      [impl = m_impl.get()](const AngleChoices& value) { impl->applyChoices(value); }));
}

void AngleDocument::setPlan(const devices::AnglePlan& plan) {
  if (plan == m_impl->plan) {
    return;
  }
  undoStack().push(new ChangeCommand<devices::AnglePlan>(
      tr("change plan"), m_impl->plan, plan, UndoMerge::Plan,
      [impl = m_impl.get()](const devices::AnglePlan& value) { impl->applyPlan(value); }));
}

void AngleDocument::setVerificationSweep(angle::Sweep sweep) {
  m_impl->verification = std::make_shared<const angle::Sweep>(std::move(sweep));
  m_impl->scheduleVerificationSweep();
  m_impl->updateRecompute();
  emit verificationSweepChanged();
}

void AngleDocument::reloadSweepFromSession() {
  auto* open = session();
  if (open == nullptr) {
    return;
  }
  auto samples = open->angleSamples(session::SweepRole::Calibration);
  if (!samples) {
    emit storageFailed(QString::fromStdString(samples.error().message()));
    return;
  }
  auto sweep = capturedSweep(*samples);
  if (sweep.size() == m_impl->calibration.sweep->size() && m_impl->calibration.origin == SweepOrigin::Captured) {
    sweep.enabled = m_impl->calibration.sweep->enabled; // a point was measured again: the review still fits
  } else {
    undoStack().clear(); // what could be undone speaks of rows that are gone
  }
  m_impl->applySweep({std::make_shared<const angle::Sweep>(std::move(sweep)), SweepOrigin::Captured});
  emit titleChanged();
}

} // namespace straightedge::gui
