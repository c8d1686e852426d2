// The open field calibration as the window sees it: campaign, choices and what was computed from them.
#pragma once

#include "app/gui/document/calibration_document.h"
#include "app/gui/document/field_choices.h"
#include "core/field/campaign.h"
#include "core/field/field_fit.h"
#include "core/field/storage.h"
#include "core/field/verification.h"
#include "devices/capture/field_plan.h"

#include <memory>
#include <optional>
#include <vector>

namespace straightedge::gui {

class JobRunner;

/// GUI thread. Recomputes in jobs: campaign, rows or choices change -> calibrate -> verify; each result arrives with
/// its signal. While a job runs the previous results stay visible.
///
/// What is shared is never changed, so that jobs and plots may hold on to it.
class FieldDocument : public CalibrationDocument {
  Q_OBJECT
public:
  explicit FieldDocument(JobRunner& jobs, QObject* parent = nullptr);
  ~FieldDocument() override;

  session::SessionKind kind() const override { return session::SessionKind::Field; }

  // Campaign: all rows as recorded; empty where there is none yet
  const field::Campaign& campaign() const { return *sharedCampaign(); }
  std::shared_ptr<const field::Campaign> sharedCampaign() const;
  bool isCaptured() const; ///< the campaign came from the session's samples, not from a file
  /// Data from a file replace the campaign; every row counts again (undoable).
  void setCampaign(field::Campaign campaign, const QString& undoText);
  /// After capture: samples -> campaign (latest attempt of every stage). What was switched off stays off while the
  /// number of rows stays.
  void reloadCampaignFromSession();
  bool isRowEnabled(std::size_t row) const;
  const std::vector<bool>& rowsEnabled() const; ///< one for each row of the campaign
  /// Undoable. A whole plateau or sweep is switched off by the rows of its run (campaign_runs.h). Rows that do not
  /// exist are passed over. Empty `undoText`: "switch off N rows".
  void setRowsEnabled(const std::vector<std::size_t>& rows, bool enabled, const QString& undoText = {});

  /// A fresh campaign to verify with; only its rows of the step verification count. Empty where there is none.
  const field::Campaign& verificationCampaign() const;
  void setVerificationCampaign(field::Campaign campaign); ///< empty: none
  void reloadVerificationFromSession();                   ///< after capture

  // Choices
  const FieldChoices& choices() const;
  void setChoices(const FieldChoices& choices,
                  const QString& undoText); ///< undoable; equal text in a row merges (drags)
  const devices::FieldPlan& plan() const;
  void setPlan(const devices::FieldPlan& plan); ///< undoable

  // Results: null or empty until computed, and while the data are refused
  /// Fit report, all blocks, verification before and after each block, warnings of blocks that are off.
  std::shared_ptr<const field::FieldRun> run() const;
  const std::optional<Error>& runError() const; ///< why the campaign was refused
  /// Orders of the blocks against what they leave; null until computed. It takes many fits, so it is made, and made
  /// anew after every run, only while it is wanted: the step that shows it says so when it is shown and left.
  std::shared_ptr<const field::StorageComparison> comparison() const;
  bool comparisonIsCurrent() const; ///< made from the present run, and not from the one before
  void setComparisonWanted(bool wanted);
  /// Against the limit: of the fresh campaign, else of the calibration campaign's own verification rows.
  const std::optional<field::LimitReport>& verification() const;
  bool verificationIsFresh() const;
  const std::optional<Error>& verificationError() const;

signals:
  void campaignChanged(); ///< or which of its rows count
  void choicesChanged();
  void planChanged();
  void runChanged();
  void comparisonChanged();
  void verificationCampaignChanged();
  void verificationChanged();

protected:
  QStringList load(session::Session& session) override;
  void reset() override;
  bool holdsContent() const override;
  void inputsChanged() override;

private:
  struct Impl;
  std::unique_ptr<Impl> m_impl;
};

} // namespace straightedge::gui
