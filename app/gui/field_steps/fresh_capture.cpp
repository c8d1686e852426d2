#include "app/gui/field_steps/fresh_capture.h"

#include "app/gui/document/field_document.h"
#include "app/gui/figures/figure_parts.h"

#include <utility>

namespace straightedge::gui {

namespace {
constexpr auto freshRole = session::SweepRole::Verification;
} // namespace

FreshCapture::FreshCapture(FieldDocument& document, FieldBenchLink& bench, QObject* parent)
    : QObject(parent), m_document(document), m_bench(bench) {
  connect(&document, &FieldDocument::opened, this, &FreshCapture::look);
  connect(&document, &FieldDocument::runChanged, this, &FreshCapture::look);
  connect(&document, &FieldDocument::verificationCampaignChanged, this, &FreshCapture::look);
  connect(&bench, &FieldBenchLink::connectionChanged, this, &FreshCapture::look);
  connect(&bench, &FieldBenchLink::captureEnded, this, &FreshCapture::look);
  connect(&bench, &FieldBenchLink::progressChanged, this, [this] { // comes once per frame
    if (std::exchange(m_running, m_bench.isCapturing()) != m_bench.isCapturing()) {
      look();
    }
  });
  look();
}

void FreshCapture::look() {
  m_interrupted = m_bench.interruptedPlan(freshRole);
  emit changed();
}

devices::FieldPlan FreshCapture::plan() const {
  devices::FieldPlan plan = m_document.plan();
  std::erase_if(plan.stages,
                [](const devices::FieldStage& stage) { return stage.step != field::CampaignStep::Verification; });
  for (devices::FieldStage& stage : plan.stages) {
    stage.skipped = false;
  }
  if (plan.stages.empty()) {
    devices::FieldPlanShape shape;
    shape.steps = {field::CampaignStep::Verification};
    plan.stages = devices::makeFieldPlan(shape).stages;
  }
  return plan;
}

bool FreshCapture::isRunning() const { return m_bench.isCapturing() && m_bench.captureRole() == freshRole; }

QString FreshCapture::cannot() const {
  if (!m_document.run()) {
    return tr("There is no calibration to verify yet.");
  }
  if (!m_bench.isConnected()) {
    return tr("To capture one, connect a bench in the step Connect.");
  }
  return m_bench.isCapturing() ? tr("A capture is running.") : QString();
}

void FreshCapture::start() {
  if (!cannot().isEmpty()) {
    return;
  }
  const bool resume = m_interrupted.has_value();
  const Result<void> started = m_bench.startCapture(resume ? *m_interrupted : plan(), freshRole, resume);
  m_problem = started ? QString() : fromText(started.error().message());
  look();
}

} // namespace straightedge::gui
