#include "app/gui/steps/verify_step.h"

#include "app/gui/steps/notice_list.h"
#include "app/gui/steps/result_table.h"
#include "app/gui/steps/verdict_banner.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QSplitter>
#include <QVBoxLayout>

namespace straightedge::gui {

VerifyStep::VerifyStep(StepContext context, QWidget* parent)
    : StepPage(parent), m_presenter(context.document, context.bench, context.jobs) {
  auto* page = new QVBoxLayout(this);
  m_notices = new NoticeList(this);
  page->addWidget(m_notices);
  auto* columns = new QHBoxLayout;
  columns->setSpacing(16);
  page->addLayout(columns, 1);
  columns->addWidget(makeSide());
  columns->addWidget(makeResult(), 1);
  connect(&m_presenter, &VerifyPresenter::changed, this, &VerifyStep::refresh);
  connect(&m_presenter, &VerifyPresenter::changed, this, &StepPage::availabilityChanged);
  connect(&m_presenter, &VerifyPresenter::progressChanged, this, &VerifyStep::showProgress);
}

QString VerifyStep::title() const { return tr("Verify"); }

QString VerifyStep::helpPage() const { return QStringLiteral("verify"); }

QString VerifyStep::missing() const { return m_presenter.missing(); }

void VerifyStep::entered() {
  m_shown = true;
  if (m_stale) {
    refresh();
  }
}

void VerifyStep::left() { m_shown = false; }

QWidget* VerifyStep::makeSide() {
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(12);

  auto* what = new QGroupBox(tr("Model and limit"), content);
  auto* form = new QFormLayout(what);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  m_model = new QComboBox(what);
  m_model->setObjectName(QStringLiteral("verifyModel"));
  m_limit = new QDoubleSpinBox(what);
  m_limit->setObjectName(QStringLiteral("verifyLimit"));
  m_limit->setDecimals(4);
  m_limit->setRange(0.0001, 180.0);
  m_limit->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  m_limit->setSuffix(QStringLiteral("°"));
  m_limit->setKeyboardTracking(false);
  form->addRow(tr("&Model"), m_model);
  form->addRow(tr("&Limit"), m_limit);
  column->addWidget(what);

  auto* fresh = new QGroupBox(tr("Fresh sweep"), content);
  auto* freshLayout = new QVBoxLayout(fresh);
  auto* about = new QLabel(tr("Points between those of the calibration, so that the curve is judged where nothing "
                              "pinned it down."),
                           fresh);
  about->setWordWrap(true);
  freshLayout->addWidget(about);
  auto* pointsForm = new QFormLayout;
  pointsForm->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  m_points = new QSpinBox(fresh);
  m_points->setObjectName(QStringLiteral("verifyPoints"));
  m_points->setRange(8, 3600);
  m_points->setKeyboardTracking(false);
  pointsForm->addRow(tr("&Points"), m_points);
  freshLayout->addLayout(pointsForm);
  m_capture = new QPushButton(fresh);
  m_capture->setObjectName(QStringLiteral("captureVerification"));
  freshLayout->addWidget(m_capture);
  m_progress = new QProgressBar(fresh);
  m_progress->setRange(0, 1000);
  m_progress->setTextVisible(true);
  m_progress->setVisible(false);
  freshLayout->addWidget(m_progress);
  m_captureProblem = new QLabel(fresh);
  m_captureProblem->setObjectName(QStringLiteral("captureProblem"));
  m_captureProblem->setWordWrap(true);
  freshLayout->addWidget(m_captureProblem);
  auto* load = new QPushButton(tr("Load a CSV file…"), fresh);
  load->setObjectName(QStringLiteral("loadVerification"));
  freshLayout->addWidget(load);
  m_sweep = new QLabel(fresh);
  m_sweep->setObjectName(QStringLiteral("verificationSweep"));
  m_sweep->setWordWrap(true);
  freshLayout->addWidget(m_sweep);
  column->addWidget(fresh);
  column->addStretch(1);
  auto* next = new QPushButton(tr("Go on to Export"), content);
  next->setObjectName(QStringLiteral("goToExport"));
  column->addWidget(next);

  connect(m_model, &QComboBox::activated, &m_presenter, &VerifyPresenter::selectModel);
  connect(m_limit, &QDoubleSpinBox::valueChanged, &m_presenter, &VerifyPresenter::setLimitDeg);
  connect(m_points, &QSpinBox::valueChanged, &m_presenter, &VerifyPresenter::setPoints);
  connect(m_capture, &QPushButton::clicked, this, [this] {
    if (m_presenter.isCapturing()) {
      m_presenter.stopCapture();
    } else {
      m_presenter.capture();
    }
  });
  connect(load, &QPushButton::clicked, this, &VerifyStep::chooseCsv);
  connect(next, &QPushButton::clicked, this, [this] { emit goToStep(tr("Export")); });

  auto* scroll = new QScrollArea(this);
  scroll->setWidget(content);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFixedWidth(fontMetrics().averageCharWidth() * 44);
  return scroll;
}

QWidget* VerifyStep::makeResult() {
  auto* area = new QWidget(this);
  auto* layout = new QVBoxLayout(area);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(10);
  m_banner = new VerdictBanner(area);
  layout->addWidget(m_banner);
  auto* plots = new QSplitter(Qt::Vertical, area);
  plots->setChildrenCollapsible(false);
  m_beforeAfter = new PlotView(plots);
  m_beforeAfter->setObjectName(QStringLiteral("beforeAfterPlot"));
  m_beforeAfter->setMinimumHeight(150);
  m_corrected = new PlotView(plots);
  m_corrected->setObjectName(QStringLiteral("correctedPlot"));
  m_corrected->setMinimumHeight(150);
  plots->addWidget(m_beforeAfter);
  plots->addWidget(m_corrected);
  layout->addWidget(plots, 1);
  m_table = new ResultTable(area);
  m_table->setObjectName(QStringLiteral("verificationTable"));
  layout->addWidget(m_table);
  return area;
}

void VerifyStep::refresh() {
  m_stale = !m_shown;
  if (m_stale) {
    return;
  }
  {
    const QSignalBlocker quietModel(m_model);
    const QSignalBlocker quietLimit(m_limit);
    const QSignalBlocker quietPoints(m_points);
    m_model->clear();
    m_model->addItems(m_presenter.models());
    m_model->setCurrentIndex(m_presenter.selectedModel());
    m_limit->setValue(m_presenter.limitDeg());
    m_points->setValue(m_presenter.points());
  }
  m_notices->setNotices(m_presenter.problem().isEmpty()
                            ? QList<Notice>{}
                            : QList<Notice>{{Notice::Level::Problem, m_presenter.problem()}});
  const bool capturing = m_presenter.isCapturing();
  const QString cannot = capturing ? QString() : m_presenter.captureProblem();
  m_capture->setText(capturing ? tr("Stop") : tr("&Capture on the bench"));
  m_capture->setEnabled(cannot.isEmpty());
  m_captureProblem->setText(cannot);
  m_captureProblem->setVisible(!cannot.isEmpty());
  m_progress->setVisible(capturing);
  m_sweep->setText(m_presenter.sweepText());
  m_sweep->setVisible(!m_presenter.sweepText().isEmpty());
  m_banner->setVerdict(m_presenter.outcome(), m_presenter.verdictText(), m_presenter.ruleText());
  m_beforeAfter->setSpec(m_presenter.beforeAfter());
  m_corrected->setSpec(m_presenter.corrected());
  const ReportTable table = m_presenter.table();
  m_table->setTable(table);
  m_table->setVisible(!table.rows.isEmpty());
  const int rows = static_cast<int>(table.rows.size());
  m_table->setFixedHeight(m_table->horizontalHeader()->sizeHint().height() +
                          rows * m_table->verticalHeader()->defaultSectionSize() + 2 * m_table->frameWidth() + 2);
  showProgress();
}

void VerifyStep::showProgress() {
  if (m_presenter.isCapturing()) {
    m_progress->setValue(static_cast<int>(m_presenter.progress() * 1000.0));
    m_progress->setFormat(m_presenter.progressText());
  }
}

void VerifyStep::chooseCsv() {
  const QString file =
      QFileDialog::getOpenFileName(this, tr("Load a fresh sweep"), {}, tr("Sweeps (*.csv *.txt *.tsv);;All files (*)"));
  if (!file.isEmpty()) {
    m_presenter.loadCsv(file);
  }
}

StepPage* makeVerifyStep(StepContext context, QWidget* parent) { return new VerifyStep(context, parent); }

} // namespace straightedge::gui
