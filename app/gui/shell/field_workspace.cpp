#include "app/gui/shell/field_workspace.h"

#include "app/gui/jobs/job_runner.h"
#include "app/gui/shell/field_step_catalogue.h"
#include "app/gui/shell/field_step_state.h"
#include "core/field/campaign_csv.h"

#include <QFileInfo>

#include <memory>
#include <utility>

namespace straightedge::gui {

namespace {
constexpr int fieldConnect = 0;
constexpr int fieldCapture = 1;
constexpr int fieldReview = 2;
constexpr int fieldVerify = 5;
} // namespace

FieldWorkspace::FieldWorkspace(JobRunner& jobs, QObject* parent)
    : Workspace(parent), m_jobs(jobs), m_document(jobs), m_bench(m_document) {
  for (const auto signal : {&FieldDocument::campaignChanged, &FieldDocument::runChanged,
                            &FieldDocument::verificationCampaignChanged, &FieldDocument::verificationChanged}) {
    connect(&m_document, signal, this, &Workspace::stateChanged);
  }
  connect(&m_bench, &FieldBenchLink::failed, this, &Workspace::benchFailed);
  connect(&m_bench, &FieldBenchLink::connectionChanged, this, &Workspace::stateChanged);
  connect(&m_bench, &FieldBenchLink::captureEnded, this, &Workspace::stateChanged);
  connect(&m_bench, &FieldBenchLink::progressChanged, this, [this] {
    // Many times a second: only what changes with the beginning and the end of a capture.
    if (std::exchange(m_wasCapturing, m_bench.isCapturing()) != m_bench.isCapturing()) {
      emit stateChanged();
    }
  });
}

FieldWorkspace::~FieldWorkspace() {
  m_bench.disconnect(this);
  m_document.disconnect(this);
}

std::span<const StepEntry> FieldWorkspace::steps() const { return fieldStepCatalogue(); }

StepState FieldWorkspace::state(std::size_t step) const { return fieldStepState(step, m_document, m_bench); }

StepPage* FieldWorkspace::makePage(std::size_t step, QWidget* parent) {
  return makeFieldStep(step, {m_document, m_bench, m_jobs}, parent);
}

int FieldWorkspace::firstStepAfterOpening() const {
  return m_document.campaign().rows.empty() ? fieldConnect : fieldReview;
}

ReferenceUnit FieldWorkspace::referenceUnit() const { return {QStringLiteral("T"), tr("tesla"), 100.0}; }

Result<int> FieldWorkspace::connectSimulatedBench() {
  if (!m_bench.isSimulated()) {
    if (auto connected = m_bench.connectSimulated(m_bench.simulatedSettings()); !connected) {
      return std::unexpected(std::move(connected.error()));
    }
  }
  return fieldCapture;
}

void FieldWorkspace::importFile(const QString& file, int currentStep, QWidget&) {
  const bool forVerification = currentStep == fieldVerify && !m_document.campaign().rows.empty();
  m_jobs.run<field::Campaign>(
      "read-campaign", tr("Reading %1").arg(QFileInfo(file).fileName()),
      [path = file.toStdString()](const JobControl&) { return field::readCampaignCsv(path); },
      [this, file, forVerification](Result<field::Campaign> campaign) {
        if (!campaign) {
          emit failed(QString::fromStdString(campaign.error().message()));
          return;
        }
        const auto read = std::make_shared<field::Campaign>(std::move(*campaign));
        emit dataReady(
            {file, [this, read, forVerification] { return useCampaign(std::move(*read), forVerification); }});
      });
}

Result<ReadyData> FieldWorkspace::readExample(std::string bytes, const QString& name) {
  auto campaign = field::parseCampaignCsv(std::move(bytes), name.toStdString(), name.toStdString());
  if (!campaign) {
    return std::unexpected(std::move(campaign.error()));
  }
  const auto read = std::make_shared<field::Campaign>(std::move(*campaign));
  return ReadyData{{}, [this, read] { return useCampaign(std::move(*read), false); }};
}

Landing FieldWorkspace::useCampaign(field::Campaign campaign, bool forVerification) {
  const QString name = QString::fromStdString(campaign.name);
  const QString text = tr("%1 rows read from %2").arg(campaign.rows.size()).arg(name);
  if (forVerification && !m_document.campaign().rows.empty()) {
    m_document.setVerificationCampaign(std::move(campaign));
    return {fieldVerify, text};
  }
  m_document.setCampaign(std::move(campaign), tr("import %1").arg(name));
  return {fieldReview, text};
}

} // namespace straightedge::gui
