#include "app/gui/shell/angle_workspace.h"

#include "app/gui/jobs/job_runner.h"
#include "app/gui/shell/angle_step_state.h"
#include "app/gui/shell/import_dialog.h"
#include "app/gui/shell/step_catalogue.h"

#include <QFileInfo>

#include <memory>
#include <utility>

namespace straightedge::gui {

namespace {
constexpr int angleConnect = 0;
constexpr int angleCapture = 1;
constexpr int angleReview = 2;
constexpr int angleVerify = 5;
} // namespace

AngleWorkspace::AngleWorkspace(JobRunner& jobs, QObject* parent)
    : Workspace(parent), m_jobs(jobs), m_document(jobs), m_bench(m_document) {
  for (const auto signal : {&AngleDocument::sweepChanged, &AngleDocument::runChanged, &AngleDocument::comparisonChanged,
                            &AngleDocument::verificationChanged, &AngleDocument::verificationSweepChanged}) {
    connect(&m_document, signal, this, &Workspace::stateChanged);
  }
  connect(&m_bench, &BenchLink::failed, this, &Workspace::benchFailed);
  connect(&m_bench, &BenchLink::connectionChanged, this, &Workspace::stateChanged);
  connect(&m_bench, &BenchLink::captureEnded, this, &Workspace::stateChanged);
  connect(&m_bench, &BenchLink::progressChanged, this, [this] {
    // Many times a second: only what changes with the beginning and the end of a capture.
    if (std::exchange(m_wasCapturing, m_bench.isCapturing()) != m_bench.isCapturing()) {
      emit stateChanged();
    }
  });
}

AngleWorkspace::~AngleWorkspace() {
  m_bench.disconnect(this);
  m_document.disconnect(this);
}

ImportDialog* AngleWorkspace::importDialog() const { return m_import; }

std::span<const StepEntry> AngleWorkspace::steps() const { return stepCatalogue(); }

StepState AngleWorkspace::state(std::size_t step) const { return angleStepState(step, m_document, m_bench); }

StepPage* AngleWorkspace::makePage(std::size_t step, QWidget* parent) {
  return makeAngleStep(step, {m_document, m_bench, m_jobs}, parent);
}

int AngleWorkspace::firstStepAfterOpening() const { return m_document.sweep().size() > 0 ? angleReview : angleConnect; }

ReferenceUnit AngleWorkspace::referenceUnit() const { return {QStringLiteral("°"), tr("degrees"), 180.0}; }

Result<int> AngleWorkspace::connectSimulatedBench() {
  if (!m_bench.isConnected() || m_bench.benchName() != tr("Simulated bench")) {
    if (auto connected = m_bench.connectSimulated(m_bench.simulatedSettings()); !connected) {
      return std::unexpected(std::move(connected.error()));
    }
  }
  return angleCapture;
}

void AngleWorkspace::importFile(const QString& file, int currentStep, QWidget& window) {
  m_jobs.run<angle::CsvPreview>(
      "inspect-csv", tr("Reading %1").arg(QFileInfo(file).fileName()),
      [path = file.toStdString()](const JobControl&) { return angle::inspectCsv(path); },
      [this, file, currentStep, over = QPointer<QWidget>(&window)](Result<angle::CsvPreview> preview) {
        if (!preview) {
          emit failed(QString::fromStdString(preview.error().message()));
        } else if (over) {
          showImport(file, *preview, currentStep, *over);
        }
      });
}

void AngleWorkspace::showImport(const QString& file, const angle::CsvPreview& preview, int currentStep,
                                QWidget& window) {
  if (m_import) {
    m_import->close();
  }
  const bool canVerify = m_document.isOpen() && m_document.sweep().size() > 0;
  m_import = new ImportDialog(file, preview, canVerify && currentStep == angleVerify, canVerify, &window);
  m_import->setAttribute(Qt::WA_DeleteOnClose);
  connect(m_import, &QDialog::accepted, this,
          [this, file, dialog = m_import.data()] { readSweep(file, dialog->mapping(), dialog->forVerification()); });
  m_import->open();
}

void AngleWorkspace::readSweep(const QString& file, const angle::SweepMapping& mapping, bool forVerification) {
  m_jobs.run<angle::Sweep>(
      "read-csv", tr("Reading %1").arg(QFileInfo(file).fileName()),
      [path = file.toStdString(), mapping](const JobControl&) { return angle::readSweepCsv(path, mapping); },
      [this, file, forVerification](Result<angle::Sweep> sweep) {
        if (!sweep) {
          emit failed(QString::fromStdString(sweep.error().message()));
          return;
        }
        const auto read = std::make_shared<angle::Sweep>(std::move(*sweep));
        emit dataReady({file, [this, read, file, forVerification] {
                          return useSweep(std::move(*read), QFileInfo(file).fileName(), forVerification);
                        }});
      });
}

Result<ReadyData> AngleWorkspace::readExample(std::string bytes, const QString& name) {
  auto sweep = angle::parseSweepCsv(std::move(bytes), name.toStdString(), name.toStdString());
  if (!sweep) {
    return std::unexpected(std::move(sweep.error()));
  }
  const auto read = std::make_shared<angle::Sweep>(std::move(*sweep));
  return ReadyData{{}, [this, read, name] { return useSweep(std::move(*read), name, false); }};
}

Landing AngleWorkspace::useSweep(angle::Sweep sweep, const QString& name, bool forVerification) {
  const QString text = tr("%1 points read from %2").arg(sweep.size()).arg(name);
  if (forVerification) {
    m_document.setVerificationSweep(std::move(sweep));
    return {angleVerify, text};
  }
  m_document.setSweep(std::move(sweep), tr("import %1").arg(name));
  return {angleReview, text};
}

} // namespace straightedge::gui
