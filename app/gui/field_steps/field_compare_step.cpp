#include "app/gui/field_steps/field_compare_step.h"

#include "app/gui/steps/notice_list.h"
#include "app/gui/steps/result_table.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>
#include <QVBoxLayout>

namespace straightedge::gui {

FieldCompareStep::FieldCompareStep(FieldStepContext context, QWidget* parent)
    : StepPage(parent), m_presenter(context.document, context.jobs) {
  auto* page = new QVBoxLayout(this);
  m_notices = new NoticeList(this);
  page->addWidget(m_notices);
  page->addWidget(makeBar());
  m_tabs = new QTabWidget(this);
  m_tabs->setObjectName(QStringLiteral("fieldComparison"));
  m_tabs->setDocumentMode(true);
  auto* plotted = new QWidget(m_tabs);
  auto* layout = new QVBoxLayout(plotted);
  layout->setContentsMargins(0, 6, 0, 0);
  m_plot = new PlotView(plotted);
  m_plot->setObjectName(QStringLiteral("storagePlot"));
  m_plot->setMinimumHeight(240);
  auto* hint = new QLabel(tr("Click a point to fit with its order of the nonlinearity; of a block left out, that block "
                             "is switched off. Undo with Ctrl+Z."),
                          plotted);
  hint->setWordWrap(true);
  layout->addWidget(m_plot, 1);
  layout->addWidget(hint);
  m_tabs->addTab(plotted, tr("Plot"));
  m_tabs->addTab(makeTable(), tr("Table"));
  page->addWidget(m_tabs, 1);
  connect(m_plot, &PlotView::pointClicked, this, [this](int series, int index) {
    if (const auto choice = m_presenter.choiceAt(series, index)) {
      m_presenter.choose(*choice);
    }
  });
  connect(&m_presenter, &FieldComparePresenter::changed, this, &FieldCompareStep::refresh);
  connect(&m_presenter, &FieldComparePresenter::changed, this, &StepPage::availabilityChanged);
  connect(&m_presenter, &FieldComparePresenter::progressChanged, this,
          [this] { m_progress->setText(m_presenter.progressText()); });
}

QString FieldCompareStep::title() const { return tr("Compare"); }

QString FieldCompareStep::helpPage() const { return QStringLiteral("field-compare"); }

QString FieldCompareStep::missing() const { return m_presenter.missing(); }

void FieldCompareStep::entered() {
  m_shown = true;
  m_presenter.setShown(true);
  if (m_stale) {
    refresh();
  }
}

void FieldCompareStep::left() {
  m_shown = false;
  m_presenter.setShown(false);
}

QWidget* FieldCompareStep::makeBar() {
  auto* bar = new QWidget(this);
  auto* column = new QVBoxLayout(bar);
  column->setContentsMargins(0, 0, 0, 0);
  m_chosen = new QLabel(bar);
  m_chosen->setObjectName(QStringLiteral("chosenChain"));
  m_chosen->setWordWrap(true);
  m_chosen->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* next = new QPushButton(tr("Go on to Verify"), bar);
  next->setObjectName(QStringLiteral("goToVerify"));
  auto* upper = new QHBoxLayout;
  upper->addWidget(m_chosen, 1);
  upper->addWidget(next);
  column->addLayout(upper);
  auto* lower = new QHBoxLayout;
  auto* cost = new QComboBox(bar);
  cost->setObjectName(QStringLiteral("chainCost"));
  cost->addItem(tr("coefficients to store"), static_cast<int>(ChainCost::Coefficients));
  cost->addItem(tr("multiplications for one reading"), static_cast<int>(ChainCost::Multiplications));
  auto* caption = new QLabel(tr("Error &over"), bar);
  caption->setBuddy(cost);
  m_progress = new QLabel(bar);
  m_progress->setObjectName(QStringLiteral("comparisonProgress"));
  lower->addWidget(caption);
  lower->addWidget(cost);
  lower->addStretch(1);
  lower->addWidget(m_progress);
  column->addLayout(lower);
  connect(cost, &QComboBox::currentIndexChanged, this,
          [this, cost] { m_presenter.setCost(static_cast<ChainCost>(cost->currentData().toInt())); });
  connect(next, &QPushButton::clicked, this, [this] { emit goToStep(tr("Verify")); });
  return bar;
}

QWidget* FieldCompareStep::makeTable() {
  auto* area = new QWidget(this);
  auto* layout = new QVBoxLayout(area);
  layout->setContentsMargins(0, 6, 0, 0);
  auto* bar = new QHBoxLayout;
  auto* best = new QCheckBox(tr("Only the &best of each size"), area);
  best->setObjectName(QStringLiteral("onlyBest"));
  m_use = new QPushButton(tr("&Use it"), area);
  m_use->setObjectName(QStringLiteral("useChain"));
  m_use->setToolTip(tr("Fits with this order of the nonlinearity; of a block left out, switches it off"));
  auto* copy = new QPushButton(tr("Co&py table"), area);
  copy->setObjectName(QStringLiteral("copyComparison"));
  bar->addWidget(best);
  bar->addStretch(1);
  bar->addWidget(m_use);
  bar->addWidget(copy);
  layout->addLayout(bar);
  m_table = new ResultTable(area);
  m_table->setObjectName(QStringLiteral("storageTable"));
  layout->addWidget(m_table, 1);
  connect(best, &QCheckBox::toggled, &m_presenter, &FieldComparePresenter::setOnlyBest);
  connect(m_use, &QPushButton::clicked, this, [this] { chooseRow(m_table->currentRow()); });
  connect(copy, &QPushButton::clicked, m_table, &ResultTable::copy);
  connect(m_table, &QTableWidget::cellDoubleClicked, this, &FieldCompareStep::chooseRow);
  connect(m_table, &QTableWidget::itemSelectionChanged, this,
          [this] { m_use->setEnabled(!m_table->selectedItems().isEmpty()); });
  m_use->setEnabled(false);
  return area;
}

void FieldCompareStep::chooseRow(int row) {
  if (const auto choice = m_presenter.choiceOfRow(row)) {
    m_presenter.choose(*choice);
  }
}

void FieldCompareStep::refresh() {
  m_stale = !m_shown;
  if (m_stale) {
    return;
  }
  const QString missing = m_presenter.missing();
  m_notices->setNotices(missing.isEmpty() ? QList<Notice>{} : QList<Notice>{{Notice::Level::Information, missing}});
  m_chosen->setText(m_presenter.chosenText());
  m_plot->setSpec(m_presenter.figure());
  m_table->setTable(m_presenter.table());
  m_progress->setText(m_presenter.progressText());
}

StepPage* makeFieldCompareStep(FieldStepContext context, QWidget* parent) {
  return new FieldCompareStep(context, parent);
}

} // namespace straightedge::gui
