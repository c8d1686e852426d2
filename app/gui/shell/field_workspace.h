// Field calibration in the window: document, bench, the seven steps, campaigns from CSV files.
#pragma once

#include "app/gui/document/field_bench_link.h"
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
  FieldBenchLink& bench() { return m_bench; }

  std::span<const StepEntry> steps() const override;
  StepState state(std::size_t step) const override;
  StepPage* makePage(std::size_t step, QWidget* parent) override;
  int firstStepAfterOpening() const override;
  bool isCapturing() const override { return m_bench.isCapturing(); }
  void stopAndWait() override { m_bench.stopAndWait(); }
  /// A campaign's columns have names that are fixed: nothing to preview. On Verify it is a fresh campaign to verify
  /// with, elsewhere the one that is calibrated.
  void importFile(const QString& file, int currentStep, QWidget& window) override;
  Result<ReadyData> readExample(std::string bytes, const QString& name) override;
  ReferenceUnit referenceUnit() const override;

  /// Connects the simulated bench where it is not connected yet. Returns the step to go on with.
  Result<int> connectSimulatedBench();

private:
  Landing useCampaign(field::Campaign campaign, bool forVerification);

  JobRunner& m_jobs;
  FieldDocument m_document;
  FieldBenchLink m_bench;
  bool m_wasCapturing = false;
};

} // namespace straightedge::gui
