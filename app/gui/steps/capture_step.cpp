#include "app/gui/steps/capture_step.h"

#include "app/gui/document/angle_document.h"
#include "app/gui/steps/capture_column.h"
#include "app/gui/steps/capture_wiring.h"
#include "app/gui/steps/coverage_ring.h"
#include "app/gui/steps/plan_form.h"

#include <QGroupBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
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

} // namespace

CaptureStep::CaptureStep(StepContext context, QWidget* parent)
    : StepPage(parent), m_presenter(context.document, context.bench) {
  auto* page = new QVBoxLayout(this);
  m_notices = new NoticeList(this);
  page->addWidget(m_notices);

  QWidget* plan = makePlanBox();
  auto* column = new CaptureColumn({plan, makeCourseBox(), makeRingBox()}, *plan, CaptureColumn::Rest::ToLastBox, this);

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
  columns->addWidget(column);
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
  m_buttons = new CaptureButtons(box);
  layout->addWidget(m_guidance);
  layout->addWidget(m_progress);
  layout->addWidget(m_progressText);
  layout->addWidget(m_samplesText);
  layout->addWidget(m_buttons);
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
  m_redo = new QPushButton(tr("&Measure this point again"), box);
  m_redo->setObjectName(QStringLiteral("redoPoint"));
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
  wireCaptureButtons(*this, m_presenter, *m_buttons,
                     {.title = tr("Replace the sweep?"), .objectName = QStringLiteral("replaceSweep")});
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
  const bool capturing = m_presenter.canStop();
  m_plan->setEnabled(!capturing);
  m_buttons->showState(captureState(m_presenter, waits()));
  m_guidance->setText(m_presenter.guidance());
  m_guidance->setVisible(!m_presenter.guidance().isEmpty());
  showNotices();
  showProgress();
  if (!capturing) {
    showAllPlots();
  }
  emit availabilityChanged();
}

bool CaptureStep::waits() const { return m_presenter.phase() == CapturePresenter::Phase::Waiting; }

void CaptureStep::showNotices() { m_notices->setNotices(captureNotices(m_presenter.problem(), waits())); }

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
