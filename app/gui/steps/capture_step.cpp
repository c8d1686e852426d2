#include "app/gui/steps/capture_step.h"

#include "app/gui/document/angle_document.h"
#include "app/gui/steps/coverage_ring.h"
#include "app/gui/steps/notice_list.h"
#include "app/gui/steps/plan_form.h"

#include <QGroupBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QTableView>
#include <QVBoxLayout>

namespace straightedge::gui {

namespace {

// The error plot follows every frame; what the eye needs less often is painted less often, so that the window stays
// light at 10,000 readings a second.
constexpr int framesPerRing = 4;
constexpr int framesPerSensorPlot = 8;
constexpr int framesPerTable = 6;

QPushButton* button(QWidget* parent, const QString& text, const QString& name) {
  auto* made = new QPushButton(text, parent);
  made->setObjectName(name);
  return made;
}

} // namespace

CaptureStep::CaptureStep(StepContext context, QWidget* parent)
    : StepPage(parent), m_presenter(context.document, context.bench) {
  auto* page = new QVBoxLayout(this);
  m_notices = new NoticeList(this);
  page->addWidget(m_notices);

  auto* column = new QWidget;
  auto* columnLayout = new QVBoxLayout(column);
  columnLayout->setContentsMargins(0, 0, 0, 0);
  columnLayout->setSpacing(12);
  columnLayout->addWidget(makePlanBox());
  columnLayout->addWidget(makeCourseBox());
  columnLayout->addWidget(makeRingBox(), 1);
  auto* scroll = new QScrollArea(this);
  scroll->setWidget(column);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFixedWidth(fontMetrics().averageCharWidth() * 52);

  m_errorPlot = new PlotView(this);
  m_errorPlot->setObjectName(QStringLiteral("liveErrorPlot"));
  m_sensorPlot = new PlotView(this);
  m_sensorPlot->setObjectName(QStringLiteral("liveSensorPlot"));
  auto* lower = new QSplitter(Qt::Horizontal, this);
  lower->addWidget(m_sensorPlot);
  lower->addWidget(makePointsBox());
  lower->setSizes({300, 470});
  lower->setChildrenCollapsible(false);
  auto* plots = new QSplitter(Qt::Vertical, this);
  plots->addWidget(m_errorPlot);
  plots->addWidget(lower);
  plots->setSizes({560, 440});
  plots->setChildrenCollapsible(false);

  auto* columns = new QHBoxLayout;
  columns->setSpacing(16);
  columns->addWidget(scroll);
  columns->addWidget(plots, 1);
  page->addLayout(columns, 1);
  connectPresenter();
  showPlan();
  takeSamples(0);
  showColumns();
  showPhase();
}

QString CaptureStep::title() const { return tr("Capture"); }

QString CaptureStep::helpPage() const { return QStringLiteral("capture"); }

QString CaptureStep::missing() const {
  return m_presenter.phase() == CapturePresenter::Phase::NoBench ? m_presenter.guidance() : QString();
}

void CaptureStep::entered() {
  m_shown = true;
  showAllPlots();
}

void CaptureStep::left() { m_shown = false; }

QWidget* CaptureStep::makePlanBox() {
  auto* box = new QGroupBox(tr("Plan"), this);
  auto* layout = new QVBoxLayout(box);
  m_plan = new PlanForm(box);
  m_planSummary = new QLabel(box);
  m_planSummary->setObjectName(QStringLiteral("planSummary"));
  m_planSummary->setWordWrap(true);
  layout->addWidget(m_plan);
  layout->addWidget(m_planSummary);
  return box;
}

QWidget* CaptureStep::makeCourseBox() {
  auto* box = new QGroupBox(tr("Sweep"), this);
  auto* layout = new QVBoxLayout(box);
  m_guidance = new QLabel(box);
  m_guidance->setObjectName(QStringLiteral("captureGuidance"));
  m_guidance->setWordWrap(true);
  m_progress = new QProgressBar(box);
  m_progress->setObjectName(QStringLiteral("captureProgress"));
  m_progress->setRange(0, 1000);
  m_progress->setTextVisible(false);
  m_progressText = new QLabel(box);
  m_progressText->setObjectName(QStringLiteral("captureProgressText"));
  m_samplesText = new QLabel(box);
  m_samplesText->setObjectName(QStringLiteral("captureSamples"));
  m_start = button(box, tr("&Start"), QStringLiteral("startCapture"));
  m_continue = button(box, tr("&Go on"), QStringLiteral("continueCapture"));
  m_pause = button(box, tr("&Pause"), QStringLiteral("pauseCapture"));
  m_stop = button(box, tr("S&top"), QStringLiteral("stopCapture"));
  m_connect = button(box, tr("Go to Connect"), QStringLiteral("goToConnect"));
  m_next = button(box, tr("Go on to Review"), QStringLiteral("goToReview"));
  layout->addWidget(m_guidance);
  layout->addWidget(m_progress);
  layout->addWidget(m_progressText);
  layout->addWidget(m_samplesText);
  auto* buttons = new QHBoxLayout;
  for (QPushButton* each : {m_continue, m_start, m_pause, m_stop, m_connect}) {
    buttons->addWidget(each);
  }
  buttons->addStretch(1);
  buttons->addWidget(m_next);
  layout->addLayout(buttons);
  return box;
}

QWidget* CaptureStep::makeRingBox() {
  auto* box = new QGroupBox(tr("Coverage"), this);
  auto* layout = new QVBoxLayout(box);
  m_ring = new CoverageRing(box);
  m_ring->setObjectName(QStringLiteral("coverageRing"));
  layout->addWidget(m_ring);
  return box;
}

QWidget* CaptureStep::makePointsBox() {
  auto* box = new QWidget(this);
  auto* layout = new QVBoxLayout(box);
  layout->setContentsMargins(0, 0, 0, 0);
  m_table = new QTableView(box);
  m_table->setObjectName(QStringLiteral("capturePoints"));
  m_table->setModel(&m_presenter.points());
  m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
  m_table->setSelectionMode(QAbstractItemView::SingleSelection);
  m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  m_table->setAlternatingRowColors(true);
  m_table->setShowGrid(false);
  m_table->setWordWrap(false);
  m_table->verticalHeader()->hide();
  m_table->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 8);
  m_table->horizontalHeader()->setStretchLastSection(true);
  m_table->horizontalHeader()->setHighlightSections(false);
  const int character = fontMetrics().averageCharWidth();
  for (const auto& [column, characters] : {std::pair{CapturePointsModel::Point, 7},
                                           {CapturePointsModel::Turn, 7},
                                           {CapturePointsModel::Direction, 11},
                                           {CapturePointsModel::Planned, 10},
                                           {CapturePointsModel::Sensor, 11},
                                           {CapturePointsModel::Error, 11}}) {
    m_table->setColumnWidth(column, character * characters);
  }
  m_redo = button(box, tr("&Measure this point again"), QStringLiteral("redoPoint"));
  m_redo->setToolTip(tr("Select a point in the table or click it in a plot"));
  auto* row = new QHBoxLayout;
  row->addStretch(1);
  row->addWidget(m_redo);
  layout->addWidget(m_table, 1);
  layout->addLayout(row);
  return box;
}

void CaptureStep::connectPresenter() {
  connect(&m_presenter, &CapturePresenter::phaseChanged, this, &CaptureStep::showPhase);
  connect(&m_presenter, &CapturePresenter::planChanged, this, &CaptureStep::showPlan);
  connect(&m_presenter, &CapturePresenter::guidanceChanged, this, [this] {
    m_guidance->setText(m_presenter.guidance());
    m_guidance->setVisible(!m_presenter.guidance().isEmpty());
  });
  connect(&m_presenter, &CapturePresenter::problemChanged, this, &CaptureStep::showNotices);
  connect(&m_presenter, &CapturePresenter::progressChanged, this, &CaptureStep::showFrame);
  connect(&m_presenter, &CapturePresenter::samplesArrived, this, &CaptureStep::takeSamples);
  connect(m_plan, &PlanForm::planEdited, this, [this] { m_presenter.setPlan(m_plan->plan()); });
  connect(m_start, &QPushButton::clicked, this, &CaptureStep::start);
  connect(m_continue, &QPushButton::clicked, &m_presenter, &CapturePresenter::continueInterrupted);
  connect(m_pause, &QPushButton::clicked, this, [this] {
    if (m_presenter.canResume()) {
      m_presenter.resume();
    } else {
      m_presenter.pause();
    }
  });
  connect(m_stop, &QPushButton::clicked, &m_presenter, &CapturePresenter::stop);
  connect(m_connect, &QPushButton::clicked, this, [this] { emit goToStep(tr("Connect")); });
  connect(m_next, &QPushButton::clicked, this, [this] { emit goToStep(tr("Review")); });
  connect(m_redo, &QPushButton::clicked, this, [this] {
    if (const std::optional<int> point = selectedPoint()) {
      m_presenter.redo(*point);
    }
  });
  connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this, &CaptureStep::showProgress);
  for (PlotView* plot : {m_errorPlot, m_sensorPlot}) {
    connect(plot, &PlotView::pointClicked, this, [this](int series, int index) {
      if (const std::optional<int> point = m_presenter.trace().planPoint(series, index)) {
        selectPlanPoint(*point);
      }
    });
  }
}

void CaptureStep::start() {
  if (!m_presenter.startReplacesData()) {
    m_presenter.start();
    return;
  }
  auto* question = new QMessageBox(QMessageBox::Warning, tr("Replace the sweep?"), m_presenter.replaceQuestion(),
                                   QMessageBox::Cancel, this);
  question->setObjectName(QStringLiteral("replaceSweep"));
  question->setAttribute(Qt::WA_DeleteOnClose);
  QPushButton* replace = question->addButton(tr("Replace"), QMessageBox::DestructiveRole);
  question->setDefaultButton(QMessageBox::Cancel);
  connect(replace, &QPushButton::clicked, &m_presenter, &CapturePresenter::start);
  question->open();
}

void CaptureStep::selectPlanPoint(int planPoint) {
  m_table->selectRow(planPoint);
  m_table->scrollTo(m_presenter.points().index(planPoint, 0), QAbstractItemView::PositionAtCenter);
}

std::optional<int> CaptureStep::selectedPoint() const {
  const QModelIndexList rows = m_table->selectionModel()->selectedRows();
  return rows.isEmpty() ? std::nullopt : std::optional<int>(rows.first().row());
}

void CaptureStep::showPlan() {
  m_plan->setPlan(m_presenter.plan());
  m_planSummary->setText(m_presenter.planProblem().isEmpty() ? m_presenter.planSummary() : m_presenter.planProblem());
  showPhase();
}

void CaptureStep::showColumns() {
  const devices::AnglePlan& plan = m_presenter.shownPlan();
  m_table->setColumnHidden(CapturePointsModel::Turn, plan.turns == 1);
  m_table->setColumnHidden(CapturePointsModel::Direction, !plan.bothDirections);
}

void CaptureStep::showPhase() {
  using Phase = CapturePresenter::Phase;
  const Phase phase = m_presenter.phase();
  const bool capturing = m_presenter.canStop();
  const bool complete = phase == Phase::Ready && m_presenter.points().measuredPoints() > 0;
  m_plan->setEnabled(!capturing);
  m_start->setVisible(!capturing && phase != Phase::NoBench);
  m_start->setEnabled(m_presenter.canStart());
  m_start->setText(m_presenter.startReplacesData() ? tr("&Start over…") : tr("&Start"));
  m_start->setDefault(phase == Phase::Ready && !complete);
  m_continue->setVisible(m_presenter.canContinueInterrupted());
  m_continue->setDefault(true);
  m_pause->setVisible(capturing && phase != Phase::Waiting);
  m_pause->setText(m_presenter.canResume() ? tr("&Resume") : tr("&Pause"));
  m_stop->setVisible(capturing);
  m_connect->setVisible(phase == Phase::NoBench);
  m_next->setVisible(complete || phase == Phase::Interrupted);
  m_next->setDefault(complete);
  m_guidance->setText(m_presenter.guidance());
  m_guidance->setVisible(!m_presenter.guidance().isEmpty());
  showNotices();
  showProgress();
  if (!capturing) {
    showAllPlots();
  }
  emit availabilityChanged();
}

void CaptureStep::showNotices() {
  const bool waits = m_presenter.phase() == CapturePresenter::Phase::Waiting;
  const Notice::Level level = waits ? Notice::Level::Warning : Notice::Level::Problem;
  m_notices->setNotices(m_presenter.problem().isEmpty() ? QList<Notice>{}
                                                        : QList<Notice>{{level, m_presenter.problem()}});
}

void CaptureStep::showProgress() {
  showColumns();
  const bool begun = m_presenter.canStop() || m_presenter.points().measuredPoints() > 0;
  for (QWidget* each : std::initializer_list<QWidget*>{m_progress, m_progressText, m_samplesText}) {
    each->setVisible(begun);
  }
  m_progress->setValue(static_cast<int>(m_presenter.progressFraction() * m_progress->maximum()));
  m_progressText->setText(m_presenter.progressText());
  m_samplesText->setText(m_presenter.samplesText());
  m_ring->setCaption(tr("%1 %").arg(m_ring->coveredPercent()), tr("of the plan"));
  m_redo->setEnabled(m_presenter.canRedo(selectedPoint()));
}

void CaptureStep::takeSamples(int first) {
  if (first == 0) {
    std::vector<double> turn;
    const devices::AnglePlan& plan = m_presenter.shownPlan();
    turn.reserve(static_cast<std::size_t>(plan.pointsPerTurn));
    for (int i = 0; i < plan.pointsPerTurn; ++i) {
      turn.push_back(plan.startDeg + 360.0 * i / plan.pointsPerTurn);
    }
    m_ring->setPlan(std::move(turn), plan.bothDirections);
  }
  for (const session::AngleSample& sample : m_presenter.samplesFrom(first)) {
    m_ring->measure(sample.encoderDeg, sample.direction);
  }
}

void CaptureStep::showFrame() {
  if (!m_shown) {
    return;
  }
  ++m_frame;
  m_errorPlot->setSpec(m_presenter.trace().errorPlot());
  if (m_frame % framesPerRing == 0) {
    m_ring->update();
  }
  if (m_frame % framesPerSensorPlot == 1) {
    m_sensorPlot->setSpec(m_presenter.trace().sensorPlot());
  }
  if (m_frame % framesPerTable == 2) {
    m_presenter.points().flush();
    showProgress();
  }
}

void CaptureStep::showAllPlots() {
  m_errorPlot->setSpec(m_presenter.trace().errorPlot());
  m_sensorPlot->setSpec(m_presenter.trace().sensorPlot());
  m_presenter.points().flush();
  m_ring->update();
  showProgress();
}

StepPage* makeCaptureStep(StepContext context, QWidget* parent) { return new CaptureStep(context, parent); }

} // namespace straightedge::gui
