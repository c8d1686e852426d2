#include "app/gui/field_steps/field_verify_step.h"

#include "app/gui/field_steps/field_figure_chooser.h"
#include "app/gui/steps/notice_list.h"
#include "app/gui/steps/result_table.h"
#include "app/gui/steps/verdict_banner.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSplitter>
#include <QVBoxLayout>

namespace straightedge::gui {

FieldVerifyStep::FieldVerifyStep(FieldStepContext context, QWidget* parent)
    : StepPage(parent), m_presenter(context.document, context.jobs) {
  auto* page = new QVBoxLayout(this);
  m_notices = new NoticeList(this);
  page->addWidget(m_notices);
  auto* columns = new QHBoxLayout;
  columns->setSpacing(16);
  page->addLayout(columns, 1);
  columns->addWidget(makeSide());
  columns->addWidget(makeResult(), 1);
  connect(&m_presenter, &FieldVerifyPresenter::changed, this, &FieldVerifyStep::refresh);
  connect(&m_presenter, &FieldVerifyPresenter::changed, this, &StepPage::availabilityChanged);
}

QString FieldVerifyStep::title() const { return tr("Verify"); }

QString FieldVerifyStep::helpPage() const { return QStringLiteral("field-verify"); }

QString FieldVerifyStep::missing() const { return m_presenter.missing(); }

void FieldVerifyStep::entered() {
  m_shown = true;
  if (m_stale) {
    refresh();
  }
}

void FieldVerifyStep::left() { m_shown = false; }

QWidget* FieldVerifyStep::makeSide() {
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(12);

  auto* limit = new QGroupBox(tr("Limit"), content);
  auto* form = new QFormLayout(limit);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  m_limit = new QDoubleSpinBox(limit);
  m_limit->setObjectName(QStringLiteral("fieldLimit"));
  m_limit->setDecimals(4);
  m_limit->setRange(0.0001, 100.0);
  m_limit->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  m_limit->setSuffix(tr(" %"));
  m_limit->setKeyboardTracking(false);
  m_of = new QComboBox(limit);
  m_of->setObjectName(QStringLiteral("percentOf"));
  m_of->addItem(tr("full scale"), static_cast<int>(field::PercentOf::FullScale));
  m_of->addItem(tr("reading"), static_cast<int>(field::PercentOf::Reading));
  m_of->setItemData(1, tr("Only fields of at least %1 % of full scale count").arg(field::leastOfReading * 100.0),
                    Qt::ToolTipRole);
  form->addRow(tr("&Limit"), m_limit);
  form->addRow(tr("O&f"), m_of);
  column->addWidget(limit);

  auto* fresh = new QGroupBox(tr("Fresh campaign"), content);
  auto* freshLayout = new QVBoxLayout(fresh);
  auto* about = new QLabel(tr("Rows of the step verification: known fields at temperatures that the calibration was "
                              "not made from. Without a fresh campaign the calibration's own are used."),
                           fresh);
  about->setWordWrap(true);
  freshLayout->addWidget(about);
  auto* load = new QPushButton(tr("Load a C&SV file…"), fresh);
  load->setObjectName(QStringLiteral("loadVerification"));
  freshLayout->addWidget(load);
  m_forget = new QPushButton(tr("Back to its &own rows"), fresh);
  m_forget->setObjectName(QStringLiteral("forgetVerification"));
  freshLayout->addWidget(m_forget);
  m_campaign = new QLabel(fresh);
  m_campaign->setObjectName(QStringLiteral("verificationCampaign"));
  m_campaign->setWordWrap(true);
  m_campaign->setTextInteractionFlags(Qt::TextSelectableByMouse);
  freshLayout->addWidget(m_campaign);
  column->addWidget(fresh);
  column->addStretch(1);
  auto* next = new QPushButton(tr("Go on to Export"), content);
  next->setObjectName(QStringLiteral("goToExport"));
  column->addWidget(next);

  connect(m_limit, &QDoubleSpinBox::valueChanged, &m_presenter, &FieldVerifyPresenter::setLimitPercent);
  connect(m_of, &QComboBox::activated, this,
          [this] { m_presenter.setPercentOf(static_cast<field::PercentOf>(m_of->currentData().toInt())); });
  connect(load, &QPushButton::clicked, this, &FieldVerifyStep::chooseCsv);
  connect(m_forget, &QPushButton::clicked, &m_presenter, &FieldVerifyPresenter::forgetFresh);
  connect(next, &QPushButton::clicked, this, [this] { emit goToStep(tr("Export")); });

  auto* scroll = new QScrollArea(this);
  scroll->setWidget(content);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFixedWidth(fontMetrics().averageCharWidth() * 44);
  return scroll;
}

QWidget* FieldVerifyStep::makeResult() {
  auto* area = new QWidget(this);
  auto* layout = new QVBoxLayout(area);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(10);
  m_banner = new VerdictBanner(area);
  layout->addWidget(m_banner);
  auto* splitter = new QSplitter(Qt::Vertical, area);
  splitter->setChildrenCollapsible(false);
  m_figures = new FieldFigureChooser(QStringLiteral("verify"), splitter);
  m_table = new ResultTable(splitter);
  m_table->setObjectName(QStringLiteral("verificationTable"));
  m_table->setMinimumHeight(110);
  splitter->addWidget(m_figures);
  splitter->addWidget(m_table);
  splitter->setStretchFactor(0, 3);
  splitter->setStretchFactor(1, 2);
  layout->addWidget(splitter, 1);
  return area;
}

void FieldVerifyStep::refresh() {
  m_stale = !m_shown;
  if (m_stale) {
    return;
  }
  {
    const QSignalBlocker quietLimit(m_limit);
    const QSignalBlocker quietOf(m_of);
    m_limit->setValue(m_presenter.limitPercent());
    m_of->setCurrentIndex(m_of->findData(static_cast<int>(m_presenter.percentOf())));
  }
  m_notices->setNotices(m_presenter.problem().isEmpty()
                            ? QList<Notice>{}
                            : QList<Notice>{{Notice::Level::Problem, m_presenter.problem()}});
  m_campaign->setText(m_presenter.campaignText());
  m_campaign->setVisible(!m_presenter.campaignText().isEmpty());
  m_forget->setVisible(m_presenter.hasFresh());
  m_banner->setVerdict(m_presenter.outcome(), m_presenter.verdictText(), m_presenter.ruleText());
  m_figures->setFigures(m_presenter.figures(), m_presenter.emptyPlot());
  const ReportTable table = m_presenter.table();
  m_table->setTable(table);
  m_table->setVisible(!table.rows.isEmpty());
}

void FieldVerifyStep::chooseCsv() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Load a fresh campaign"), {},
                                                    tr("Campaigns (*.csv *.txt *.tsv);;All files (*)"));
  if (!file.isEmpty()) {
    m_presenter.loadCsv(file);
  }
}

StepPage* makeFieldVerifyStep(FieldStepContext context, QWidget* parent) {
  return new FieldVerifyStep(context, parent);
}

} // namespace straightedge::gui
