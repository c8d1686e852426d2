// Angle calibration in the window: document, bench, the seven steps, sweeps from CSV files.
#pragma once

#include "app/gui/document/angle_document.h"
#include "app/gui/document/bench_link.h"
#include "app/gui/shell/workspace.h"
#include "core/angle/sweep_csv.h"

#include <QPointer>

namespace straightedge::gui {

class ImportDialog;
class JobRunner;

class AngleWorkspace : public Workspace {
  Q_OBJECT
public:
  explicit AngleWorkspace(JobRunner& jobs, QObject* parent = nullptr);
  ~AngleWorkspace() override;

  AngleDocument& document() override { return m_document; }
  BenchLink& bench() { return m_bench; }
  ImportDialog* importDialog() const; ///< null where none is shown

  std::span<const StepEntry> steps() const override;
  StepState state(std::size_t step) const override;
  StepPage* makePage(std::size_t step, QWidget* parent) override;
  int firstStepAfterOpening() const override;
  bool isCapturing() const override { return m_bench.isCapturing(); }
  void stopAndWait() override { m_bench.stopAndWait(); }
  void importFile(const QString& file, int currentStep, QWidget& window) override;
  Result<ReadyData> readExample(std::string bytes, const QString& name) override;
  ReferenceUnit referenceUnit() const override;

  /// Connects the simulated bench where it is not connected yet. Returns the step to go on with.
  Result<int> connectSimulatedBench();

private:
  void showImport(const QString& file, const angle::CsvPreview& preview, int currentStep, QWidget& window);
  void readSweep(const QString& file, const angle::SweepMapping& mapping, bool forVerification);
  Landing useSweep(angle::Sweep sweep, const QString& name, bool forVerification);

  JobRunner& m_jobs;
  AngleDocument m_document;
  BenchLink m_bench;
  QPointer<ImportDialog> m_import;
  bool m_wasCapturing = false;
};

} // namespace straightedge::gui
