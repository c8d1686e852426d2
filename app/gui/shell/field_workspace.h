// Field calibration in the window: document, the seven steps, campaigns from CSV files.
#pragma once

#include "app/gui/document/field_document.h"
#include "app/gui/shell/workspace.h"

namespace straightedge::gui {

class JobRunner;

class FieldWorkspace : public Workspace {
  Q_OBJECT
public:
  explicit FieldWorkspace(JobRunner& jobs, QObject* parent = nullptr);
  ~FieldWorkspace() override;

  FieldDocument& document() override { return m_document; }

  std::span<const StepEntry> steps() const override;
  StepState state(std::size_t step) const override;
  StepPage* makePage(std::size_t step, QWidget* parent) override;
  int firstStepAfterOpening() const override;
  bool isCapturing() const override { return false; }
  void stopAndWait() override {}
  /// A campaign's columns have names that are fixed: nothing to preview. On Verify it is a fresh campaign to verify
  /// with, elsewhere the one that is calibrated.
  void importFile(const QString& file, int currentStep, QWidget& window) override;
  Result<ReadyData> readExample(std::string bytes, const QString& name) override;
  ReferenceUnit referenceUnit() const override;

private:
  Landing useCampaign(field::Campaign campaign, bool forVerification);

  JobRunner& m_jobs;
  FieldDocument m_document;
};

} // namespace straightedge::gui
