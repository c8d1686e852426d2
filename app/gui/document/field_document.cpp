#include "app/gui/document/field_document.h"

#include "app/gui/document/field_document_state.h"
#include "app/gui/document/undo_commands.h"

#include <utility>

namespace straightedge::gui {

FieldDocument::FieldDocument(JobRunner& jobs, QObject* parent)
    : CalibrationDocument(parent), m_impl(std::make_unique<Impl>(*this, jobs)) {
  connect(&m_impl->recompute, &FieldRecompute::runChanged, this, [this] { m_impl->keepRun(); });
  connect(&m_impl->recompute, &FieldRecompute::runChanged, this, &FieldDocument::runChanged);
  connect(&m_impl->recompute, &FieldRecompute::comparisonChanged, this, &FieldDocument::comparisonChanged);
  connect(&m_impl->recompute, &FieldRecompute::verificationChanged, this, &FieldDocument::verificationChanged);
}

FieldDocument::~FieldDocument() { endLife(); }

std::shared_ptr<const field::Campaign> FieldDocument::sharedCampaign() const { return m_impl->calibration.campaign; }

bool FieldDocument::isCaptured() const { return m_impl->calibration.origin == CampaignOrigin::Captured; }

bool FieldDocument::isRowEnabled(std::size_t row) const {
  const auto& enabled = rowsEnabled();
  return row < enabled.size() && enabled[row];
}

const std::vector<bool>& FieldDocument::rowsEnabled() const { return *m_impl->calibration.enabled; }

const field::Campaign& FieldDocument::verificationCampaign() const { return *m_impl->verification; }

const FieldChoices& FieldDocument::choices() const { return m_impl->choices; }

const devices::FieldPlan& FieldDocument::plan() const { return m_impl->plan; }

std::shared_ptr<const field::FieldRun> FieldDocument::run() const { return m_impl->recompute.run; }

const std::optional<Error>& FieldDocument::runError() const { return m_impl->recompute.runError; }

std::shared_ptr<const field::StorageComparison> FieldDocument::comparison() const {
  return m_impl->recompute.comparison;
}

bool FieldDocument::comparisonIsCurrent() const { return m_impl->recompute.comparisonIsCurrent; }

void FieldDocument::setComparisonWanted(bool wanted) { m_impl->recompute.setComparisonWanted(wanted); }

const std::optional<field::LimitReport>& FieldDocument::verification() const { return m_impl->recompute.verification; }

bool FieldDocument::verificationIsFresh() const { return m_impl->recompute.verificationIsFresh; }

const std::optional<Error>& FieldDocument::verificationError() const { return m_impl->recompute.verificationError; }

void FieldDocument::setCampaign(field::Campaign campaign, const QString& undoText) {
  const std::size_t rows = campaign.rows.size();
  CampaignState after{std::make_shared<const field::Campaign>(std::move(campaign)),
                      std::make_shared<const std::vector<bool>>(rows, true), CampaignOrigin::Imported};
  undoStack().push(new ChangeCommand<CampaignState>(
      undoText, m_impl->calibration, std::move(after), UndoMerge::Never,
      [impl = m_impl.get()](const CampaignState& state) { impl->applyCampaign(state); }));
}

void FieldDocument::setRowsEnabled(const std::vector<std::size_t>& rows, bool enabled, const QString& undoText) {
  auto changed = std::make_shared<std::vector<bool>>(rowsEnabled());
  int count = 0;
  for (const std::size_t row : rows) {
    if (row < changed->size() && (*changed)[row] != enabled) {
      (*changed)[row] = enabled;
      ++count;
    }
  }
  if (count == 0) {
    return;
  }
  using Shared = std::shared_ptr<const std::vector<bool>>;
  const QString text = !undoText.isEmpty() ? undoText
                       : enabled           ? tr("switch on %n row(s)", nullptr, count)
                                           : tr("switch off %n row(s)", nullptr, count);
  undoStack().push(
      new ChangeCommand<Shared>(text, m_impl->calibration.enabled, std::move(changed), UndoMerge::Never,
                                [impl = m_impl.get()](const Shared& value) { impl->applyEnabled(value); }));
}

void FieldDocument::setChoices(const FieldChoices& choices, const QString& undoText) {
  if (choices == m_impl->choices) {
    return;
  }
  undoStack().push(
      new ChangeCommand<FieldChoices>(undoText, m_impl->choices, choices, UndoMerge::Choices,
                                      [impl = m_impl.get()](const FieldChoices& value) { impl->applyChoices(value); }));
}

void FieldDocument::setPlan(const devices::FieldPlan& plan) {
  if (plan == m_impl->plan) {
    return;
  }
  undoStack().push(new ChangeCommand<devices::FieldPlan>(
      tr("change plan"), m_impl->plan, plan, UndoMerge::Plan,
      [impl = m_impl.get()](const devices::FieldPlan& value) { impl->applyPlan(value); }));
}

void FieldDocument::setVerificationCampaign(field::Campaign campaign) {
  m_impl->verification = std::make_shared<const field::Campaign>(std::move(campaign));
  m_impl->scheduleVerificationCampaign(true);
  m_impl->updateRecompute();
  emit verificationCampaignChanged();
  emit titleChanged();
}

void FieldDocument::reloadVerificationFromSession() {
  if (session() == nullptr) {
    return;
  }
  QStringList problems;
  m_impl->verification = m_impl->captured(*session(), session::SweepRole::Verification, problems);
  m_impl->scheduleVerificationCampaign(false);
  m_impl->updateRecompute();
  emit verificationCampaignChanged();
  emit titleChanged();
  if (!problems.isEmpty()) {
    emit storageFailed(problems.join('\n'));
  }
}

void FieldDocument::reloadCampaignFromSession() {
  if (session() == nullptr) {
    return;
  }
  QStringList problems;
  auto campaign = m_impl->captured(*session(), session::SweepRole::Calibration, problems);
  if (!problems.isEmpty()) {
    emit storageFailed(problems.join('\n'));
    return;
  }
  auto enabled = m_impl->calibration.enabled;
  if (!isCaptured() || enabled->size() != campaign->rows.size()) {
    enabled = std::make_shared<const std::vector<bool>>(campaign->rows.size(), true);
    undoStack().clear(); // what could be undone speaks of rows that are gone
  }
  m_impl->applyCampaign({std::move(campaign), std::move(enabled), CampaignOrigin::Captured});
  emit titleChanged();
}

} // namespace straightedge::gui
