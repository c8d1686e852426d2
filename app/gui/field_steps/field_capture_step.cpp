#include "app/gui/field_steps/field_capture_step.h"

#include "app/gui/field_steps/field_plan_form.h"
#include "app/gui/field_steps/stage_list.h"
#include "app/gui/steps/notice_list.h"

#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSplitter>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace straightedge::gui {

namespace {

// What the eye needs less often is painted less often; both plots and the list take turns.
constexpr int framesPerTurn = 6;
constexpr int turnOfMainPlot = 1;
constexpr int turnOfTimePlot = 3;
constexpr int turnOfStages = 5;

QPushButton* captureButton(QWidget* parent, const QString& text, const QString& name) {
  auto* made = new QPushButton(text, parent);
  made->setObjectName(name);
  return made;
}

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
  auto* column = new QWidget;
  auto* columnLayout = new QVBoxLayout(column);
  columnLayout->setContentsMargins(0, 0, 0, 0);
  columnLayout->setSpacing(12);
  columnLayout->addWidget(makeGuide());
  QWidget* plan = makePlanBox();
  columnLayout->addWidget(plan);
  columnLayout->addStretch(1);
  auto* scroll = new QScrollArea(this);
  scroll->setWidget(column);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFixedWidth(std::max(fontMetrics().averageCharWidth() * 52,
                                 plan->minimumSizeHint().width() + scroll->verticalScrollBar()->sizeHint().width()));
  auto* columns = new QHBoxLayout;
  columns->setSpacing(16);
  columns->addWidget(scroll);
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
  m_confirm = captureButton(m_guide, tr("&Done, go on"), QStringLiteral("confirmStage"));
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
  m_start = captureButton(m_guide, tr("&Start"), QStringLiteral("startCapture"));
  m_continue = captureButton(m_guide, tr("&Go on"), QStringLiteral("continueCapture"));
  m_pause = captureButton(m_guide, tr("&Pause"), QStringLiteral("pauseCapture"));
  m_stop = captureButton(m_guide, tr("S&top"), QStringLiteral("stopCapture"));
  m_connect = captureButton(m_guide, tr("Go to Connect"), QStringLiteral("goToConnect"));
  m_next = captureButton(m_guide, {}, QStringLiteral("goOn"));
  auto* buttons = new QHBoxLayout;
  for (QPushButton* each : {m_continue, m_start, m_pause, m_stop, m_connect}) {
    buttons->addWidget(each);
  }
  buttons->addStretch(1);
  buttons->addWidget(m_next);
  layout->addLayout(buttons);
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
  connect(m_start, &QPushButton::clicked, this, &FieldCaptureStep::start);
  connect(m_continue, &QPushButton::clicked, &m_presenter, &FieldCapturePresenter::continueInterrupted);
  connect(m_pause, &QPushButton::clicked, this, [this] {
    if (m_presenter.canResume()) {
      m_presenter.resume();
    } else {
      m_presenter.pause();
    }
  });
  connect(m_stop, &QPushButton::clicked, &m_presenter, &FieldCapturePresenter::stop);
  connect(m_connect, &QPushButton::clicked, this, [this] { emit goToStep(tr("Connect")); });
  connect(m_next, &QPushButton::clicked, this, [this] { emit goToStep(m_presenter.nextStep()); });
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

void FieldCaptureStep::start() {
  if (!m_presenter.startReplacesData()) {
    m_presenter.start();
    return;
  }
  auto* question = new QMessageBox(QMessageBox::Warning, tr("Replace the campaign?"), m_presenter.replaceQuestion(),
                                   QMessageBox::Cancel, this);
  question->setObjectName(QStringLiteral("replaceCampaign"));
  question->setAttribute(Qt::WA_DeleteOnClose);
  QPushButton* replace = question->addButton(tr("Replace"), QMessageBox::DestructiveRole);
  question->setDefaultButton(QMessageBox::Cancel);
  connect(replace, &QPushButton::clicked, &m_presenter, &FieldCapturePresenter::start);
  question->open();
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
  m_start->setVisible(!capturing && phase != CapturePhase::NoBench);
  m_start->setEnabled(m_presenter.canStart());
  m_start->setText(m_presenter.startReplacesData() ? tr("&Start over…") : tr("&Start"));
  m_start->setDefault(phase == CapturePhase::Ready && !m_presenter.isComplete());
  m_continue->setVisible(m_presenter.canContinueInterrupted());
  m_continue->setDefault(m_presenter.canContinueInterrupted());
  m_pause->setVisible(capturing && phase != CapturePhase::Unplugged);
  m_pause->setText(m_presenter.canResume() ? tr("&Resume") : tr("&Pause"));
  m_stop->setVisible(capturing);
  m_connect->setVisible(phase == CapturePhase::NoBench);
  m_next->setVisible(!m_presenter.nextStep().isEmpty());
  m_next->setText(tr("Go on to %1").arg(m_presenter.nextStep()));
  m_next->setDefault(m_presenter.isComplete());
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

void FieldCaptureStep::showNotices() {
  const bool comesBack = m_presenter.phase() == FieldCapturePresenter::Phase::Unplugged;
  m_notices->setNotices(
      m_presenter.problem().isEmpty()
          ? QList<Notice>{}
          : QList<Notice>{{comesBack ? Notice::Level::Warning : Notice::Level::Problem, m_presenter.problem()}});
}

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
