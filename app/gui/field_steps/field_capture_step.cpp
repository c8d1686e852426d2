#include "app/gui/field_steps/field_capture_step.h"

#include "app/gui/field_steps/field_plan_form.h"
#include "app/gui/field_steps/stage_list.h"
#include "app/gui/steps/capture_column.h"
#include "app/gui/steps/capture_wiring.h"

#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>

#include <utility>

namespace straightedge::gui {

namespace {

// What the eye needs less often is painted less often; both plots and the list take turns.
constexpr int framesPerTurn = 6;
constexpr int turnOfMainPlot = 1;
constexpr int turnOfTimePlot = 3;
constexpr int turnOfStages = 5;

QLabel* captureLabel(QWidget* parent, const QString& name) {
  auto* made = new QLabel(parent);
  made->setObjectName(name);
  made->setWordWrap(true);
  made->setTextFormat(Qt::PlainText);
  return made;
}

void showText(QLabel& label, const QString& text) {
  label.setText(text);
  label.setVisible(!text.isEmpty());
}

} // namespace

FieldCaptureStep::FieldCaptureStep(FieldStepContext context, QWidget* parent)
    : StepPage(parent), m_presenter(context.document, context.bench) {
  auto* page = new QVBoxLayout(this);
  m_notices = new NoticeList(this);
  page->addWidget(m_notices);
  QWidget* plan = makePlanBox();
  auto* column = new CaptureColumn({makeGuide(), plan}, *plan, CaptureColumn::Rest::Empty, this);
  auto* columns = new QHBoxLayout;
  columns->setSpacing(16);
  columns->addWidget(column);
  columns->addWidget(makeWork(), 1);
  page->addLayout(columns, 1);
  connectPresenter();
  connectStages();
  showPlan();
  showStages();
  showPlots();
}

QString FieldCaptureStep::title() const { return tr("Capture"); }

QString FieldCaptureStep::helpPage() const { return QStringLiteral("field-capture"); }

QString FieldCaptureStep::missing() const {
  return m_presenter.phase() == FieldCapturePresenter::Phase::NoBench ? m_presenter.guidance() : QString();
}

void FieldCaptureStep::entered() {
  m_shown = true;
  showStages();
  showPlots();
}

void FieldCaptureStep::left() { m_shown = false; }

QWidget* FieldCaptureStep::makeGuide() {
  m_guide = new QGroupBox(this);
  auto* layout = new QVBoxLayout(m_guide);
  m_heading = captureLabel(m_guide, QStringLiteral("stageHeading"));
  QFont bold = m_heading->font();
  bold.setBold(true);
  m_heading->setFont(bold);
  m_instruction = captureLabel(m_guide, QStringLiteral("stageInstruction"));
  QFont large = bold;
  large.setPointSizeF(large.pointSizeF() * 1.25);
  m_instruction->setFont(large);
  m_confirm = new QPushButton(tr("&Done, go on"), m_guide);
  m_confirm->setObjectName(QStringLiteral("confirmStage"));
  m_confirm->setFont(large);
  m_confirm->setMinimumHeight(m_confirm->fontMetrics().height() * 2);
  m_action = captureLabel(m_guide, QStringLiteral("stageAction"));
  m_guidance = captureLabel(m_guide, QStringLiteral("captureGuidance"));
  m_progress = new QProgressBar(m_guide);
  m_progress->setObjectName(QStringLiteral("captureProgress"));
  m_progress->setRange(0, 1000);
  m_progress->setTextVisible(false);
  m_progressText = captureLabel(m_guide, QStringLiteral("captureProgressText"));
  m_rowsText = captureLabel(m_guide, QStringLiteral("captureRows"));
  for (QWidget* each : std::initializer_list<QWidget*>{m_heading, m_instruction, m_confirm, m_action, m_guidance,
                                                       m_progress, m_progressText, m_rowsText}) {
    layout->addWidget(each);
  }
  m_buttons = new CaptureButtons(m_guide);
  layout->addWidget(m_buttons);
  return m_guide;
}

QWidget* FieldCaptureStep::makePlanBox() {
  auto* box = new QGroupBox(tr("Plan"), this);
  auto* layout = new QVBoxLayout(box);
  m_planSummary = captureLabel(box, QStringLiteral("planSummary"));
  m_plan = new FieldPlanForm(box);
  layout->addWidget(m_planSummary);
  layout->addWidget(m_plan);
  return box;
}

QWidget* FieldCaptureStep::makeWork() {
  auto* plots = new QSplitter(Qt::Horizontal, this);
  m_mainPlot = new PlotView(plots);
  m_mainPlot->setObjectName(QStringLiteral("stagePlot"));
  m_timePlot = new PlotView(plots);
  m_timePlot->setObjectName(QStringLiteral("stageTimePlot"));
  plots->addWidget(m_mainPlot);
  plots->addWidget(m_timePlot);
  plots->setChildrenCollapsible(false);
  plots->setSizes({500, 500});
  auto* work = new QSplitter(Qt::Vertical, this);
  m_stages = new StageList(work);
  work->addWidget(m_stages);
  work->addWidget(plots);
  work->setChildrenCollapsible(false);
  work->setSizes({560, 440});
  return work;
}

void FieldCaptureStep::connectPresenter() {
  connect(&m_presenter, &FieldCapturePresenter::phaseChanged, this, &FieldCaptureStep::showPhase);
  connect(&m_presenter, &FieldCapturePresenter::planChanged, this, &FieldCaptureStep::showPlan);
  connect(&m_presenter, &FieldCapturePresenter::stagesChanged, this, &FieldCaptureStep::showStages);
  connect(&m_presenter, &FieldCapturePresenter::problemChanged, this, &FieldCaptureStep::showNotices);
  connect(&m_presenter, &FieldCapturePresenter::progressChanged, this, &FieldCaptureStep::showFrame);
  connect(&m_presenter, &FieldCapturePresenter::traceChanged, this, [this] {
    if (!m_presenter.canStop()) { // otherwise with the next frames
      showPlots();
    }
  });
  connect(m_plan, &FieldPlanForm::planEdited, this, [this] { m_presenter.setPlan(m_plan->plan()); });
  connect(m_confirm, &QPushButton::clicked, &m_presenter, &FieldCapturePresenter::confirm);
  wireCaptureButtons(*this, m_presenter, *m_buttons,
                     {.title = tr("Replace the campaign?"), .objectName = QStringLiteral("replaceCampaign")});
}

void FieldCaptureStep::connectStages() {
  connect(m_stages, &StageList::chosen, &m_presenter, &FieldCapturePresenter::showStage);
  connect(m_stages, &StageList::selectionChanged, this, &FieldCaptureStep::showRights);
  connect(m_stages, &StageList::repeatWanted, &m_presenter, &FieldCapturePresenter::repeat);
  connect(m_stages, &StageList::leaveOutWanted, this, &FieldCaptureStep::leaveOut);
}

void FieldCaptureStep::leaveOut(const QList<int>& stages, bool out) {
  for (const int stage : stages) {
    m_presenter.leaveOut(stage, out);
  }
}

void FieldCaptureStep::showPlan() {
  m_plan->setPlan(m_presenter.plan());
  m_planSummary->setText(m_presenter.planProblem().isEmpty() ? m_presenter.planSummary() : m_presenter.planProblem());
  showPhase();
}

void FieldCaptureStep::showStages() {
  m_stages->setStages(m_presenter.stages());
  // The list follows the capture from stage to stage; between them another one may be chosen, to leave it out.
  if (std::exchange(m_followed, m_presenter.shownStage()) != m_presenter.shownStage() || m_stages->current() < 0) {
    m_stages->setCurrent(m_presenter.shownStage());
  }
  showRights();
}

void FieldCaptureStep::showRights() {
  const int chosen = m_stages->current();
  m_stages->setRights(m_presenter.canRepeat(chosen), m_presenter.canLeaveOut(chosen));
}

void FieldCaptureStep::showPhase() {
  using CapturePhase = FieldCapturePresenter::Phase;
  const CapturePhase phase = m_presenter.phase();
  const bool capturing = m_presenter.canStop();
  m_guide->setTitle(m_presenter.ofVerification() ? tr("Fresh campaign") : tr("Campaign"));
  m_plan->setEnabled(!capturing);
  m_buttons->showState(captureState(m_presenter, waits()));
  m_confirm->setVisible(phase == CapturePhase::Waiting);
  if (phase == CapturePhase::Waiting) {
    m_confirm->setDefault(true);
    if (m_shown && !m_stages->isAncestorOf(focusWidget())) {
      m_confirm->setFocus(); // Enter or Space goes on; hands are at the bench
    }
  }
  showText(*m_guidance, m_presenter.guidance());
  showNotices();
  showGuide();
  showRights();
  emit availabilityChanged();
}

bool FieldCaptureStep::waits() const { return m_presenter.phase() == FieldCapturePresenter::Phase::Unplugged; }

void FieldCaptureStep::showNotices() { m_notices->setNotices(captureNotices(m_presenter.problem(), waits())); }

void FieldCaptureStep::showGuide() {
  showText(*m_heading, m_presenter.heading());
  showText(*m_instruction, m_presenter.instruction());
  const bool running = m_presenter.phase() == FieldCapturePresenter::Phase::Running;
  m_action->setText(m_presenter.actionText());
  m_action->setVisible(running); // also while it says nothing: the buttons below do not jump
  const bool begun = m_presenter.canStop() || m_presenter.progressFraction() > 0.0;
  for (QWidget* each : std::initializer_list<QWidget*>{m_progress, m_progressText, m_rowsText}) {
    each->setVisible(begun);
  }
  m_progress->setValue(static_cast<int>(m_presenter.progressFraction() * m_progress->maximum()));
  m_progressText->setText(m_presenter.progressText());
  m_rowsText->setText(m_presenter.rowsText());
}

void FieldCaptureStep::showFrame() {
  if (!m_shown) {
    return;
  }
  m_frame = (m_frame + 1) % framesPerTurn;
  if (m_frame == turnOfMainPlot) {
    showMainPlot();
  } else if (m_frame == turnOfTimePlot) {
    showTimePlot();
  } else if (m_frame == turnOfStages) {
    showStages();
    showGuide();
  }
}

void FieldCaptureStep::showPlots() {
  showMainPlot();
  showTimePlot();
}

void FieldCaptureStep::showMainPlot() {
  if (std::exchange(m_mainDrawn, m_presenter.traceRevision()) != m_presenter.traceRevision()) {
    m_mainPlot->setSpec(m_presenter.trace().mainPlot());
  }
}

void FieldCaptureStep::showTimePlot() {
  if (std::exchange(m_timeDrawn, m_presenter.traceRevision()) != m_presenter.traceRevision()) {
    m_timePlot->setSpec(m_presenter.trace().timePlot());
  }
}

StepPage* makeFieldCaptureStep(FieldStepContext context, QWidget* parent) {
  return new FieldCaptureStep(context, parent);
}

} // namespace straightedge::gui
