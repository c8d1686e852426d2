#include "app/gui/field_steps/field_fit_step.h"

#include "app/gui/field_steps/field_figure_chooser.h"
#include "app/gui/field_steps/field_page_words.h"
#include "app/gui/steps/result_table.h"
#include "app/gui/steps/value_label.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTabWidget>
#include <QToolButton>
#include <QVBoxLayout>

namespace straightedge::gui {

FieldFitStep::FieldFitStep(FieldStepContext context, QWidget* parent)
    : StepPage(parent), m_presenter(context.document) {
  auto* page = new QVBoxLayout(this);
  m_notices = new NoticeList(this);
  page->addWidget(m_notices);
  auto* columns = new QHBoxLayout;
  columns->setSpacing(16);
  page->addLayout(columns, 1);
  columns->addWidget(makeSide());
  auto* area = new QWidget(this);
  auto* right = new QVBoxLayout(area);
  right->setContentsMargins(0, 0, 0, 0);
  m_numbers = new QHBoxLayout;
  m_numbers->setSpacing(28);
  m_numbers->addStretch(1);
  right->addLayout(m_numbers);
  auto* splitter = new QSplitter(Qt::Vertical, area);
  splitter->setChildrenCollapsible(false);
  m_figures = new FieldFigureChooser(QStringLiteral("fit"), splitter);
  splitter->addWidget(m_figures);
  splitter->addWidget(makeTables());
  splitter->setStretchFactor(0, 3);
  splitter->setStretchFactor(1, 2);
  right->addWidget(splitter, 1);
  columns->addWidget(area, 1);
  connect(&m_presenter, &FieldFitPresenter::changed, this, &FieldFitStep::refresh);
  connect(&m_presenter, &FieldFitPresenter::changed, this, &StepPage::availabilityChanged);
}

QString FieldFitStep::title() const { return tr("Fit"); }

QString FieldFitStep::helpPage() const {
  const QList<FieldFitPresenter::BlockChoice> blocks = m_presenter.blocks();
  for (int i = 0; i < m_blocks.size(); ++i) { // of the block that the keyboard is at
    if (m_blocks[i]->hasFocus() || m_blockHelps[i]->hasFocus()) {
      return blockHelpPage(blocks[i].block);
    }
  }
  return QStringLiteral("field-fit");
}

QString FieldFitStep::missing() const { return m_presenter.missing(); }

void FieldFitStep::entered() {
  m_shown = true;
  if (m_stale) {
    refresh();
  }
}

void FieldFitStep::left() { m_shown = false; }

QWidget* FieldFitStep::makeChoices(QWidget* parent) {
  auto* box = new QGroupBox(tr("Fit"), parent);
  auto* form = new QFormLayout(box);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  m_order = new QComboBox(box);
  m_order->setObjectName(QStringLiteral("fieldOrder"));
  for (int order = field::lowestOrder; order <= field::highestOrder; ++order) {
    m_order->addItem(QString::number(order), order);
  }
  m_order->setToolTip(tr("Order of the polynomial that straightens each axis"));
  m_method = new QComboBox(box);
  m_method->setObjectName(QStringLiteral("fieldMethod"));
  m_method->addItem(tr("Block after block"), static_cast<int>(field::FitMethod::Stepwise));
  m_method->addItem(tr("All blocks together"), static_cast<int>(field::FitMethod::Joint));
  m_method->setItemData(0, tr("Each block on what the ones before leave"), Qt::ToolTipRole);
  m_method->setItemData(1, tr("Nonlinear least squares over every row, begun at the fit block after block"),
                        Qt::ToolTipRole);
  const auto number = [box](const QString& name, double low, double high, int decimals, const QString& suffix) {
    auto* made = new QDoubleSpinBox(box);
    made->setObjectName(name);
    made->setDecimals(decimals);
    made->setRange(low, high);
    made->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    made->setSuffix(suffix);
    made->setKeyboardTracking(false);
    return made;
  };
  m_fullScale = number(QStringLiteral("fullScale"), 0.001, 30.0, 3, tr(" T"));
  m_fullScale->setToolTip(tr("What percentages of full scale refer to"));
  m_reference = number(QStringLiteral("referenceTemperature"), -50.0, 150.0, 2, tr(" °C"));
  m_reference->setStepType(QAbstractSpinBox::DefaultStepType);
  m_reference->setToolTip(tr("Temperature of probe and electronics at which nothing is corrected for it"));
  for (QComboBox* narrow : {m_order, m_method}) { // the column is narrow; the open list is as wide as its entries
    narrow->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    narrow->setMinimumContentsLength(6);
  }
  form->addRow(tr("&Order"), m_order);
  form->addRow(tr("&Method"), m_method);
  form->addRow(tr("Full &scale"), m_fullScale);
  form->addRow(tr("Reference a&t"), m_reference);
  connect(m_order, &QComboBox::activated, this, [this] { m_presenter.setOrder(m_order->currentData().toInt()); });
  connect(m_method, &QComboBox::activated, this,
          [this] { m_presenter.setMethod(static_cast<field::FitMethod>(m_method->currentData().toInt())); });
  connect(m_fullScale, &QDoubleSpinBox::valueChanged, &m_presenter, &FieldFitPresenter::setFullScaleT);
  connect(m_reference, &QDoubleSpinBox::valueChanged, &m_presenter, &FieldFitPresenter::setReferenceTemperatureC);
  return box;
}

QWidget* FieldFitStep::makeBlocks(QWidget* parent) {
  auto* box = new QGroupBox(tr("Blocks of the correction"), parent);
  auto* layout = new QVBoxLayout(box);
  for (const FieldFitPresenter::BlockChoice& choice : m_presenter.blocks()) {
    auto* row = new QHBoxLayout;
    auto* check = new QCheckBox(box);
    check->setObjectName(QStringLiteral("block%1").arg(static_cast<int>(choice.block)));
    auto* help = new QToolButton(box);
    help->setObjectName(QStringLiteral("blockHelp%1").arg(static_cast<int>(choice.block)));
    help->setText(QStringLiteral("?"));
    help->setAutoRaise(true);
    help->setFocusPolicy(Qt::StrongFocus);
    help->setAccessibleName(tr("Help: %1").arg(choice.title));
    help->setToolTip(tr("What %1 corrects, and how it is measured (F1)").arg(choice.title.toLower()));
    row->addWidget(check, 1);
    row->addWidget(help);
    layout->addLayout(row);
    m_blocks.append(check);
    m_blockHelps.append(help);
    connect(help, &QToolButton::clicked, this,
            [this, block = choice.block] { emit helpRequested(blockHelpPage(block)); });
    connect(check, &QCheckBox::toggled, this,
            [this, block = choice.block](bool on) { m_presenter.setBlockOn(block, on); });
  }
  return box;
}

QWidget* FieldFitStep::makeSide() {
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(12);
  column->addWidget(makeChoices(content));
  column->addWidget(makeBlocks(content));
  m_fitText = new QLabel(content);
  m_fitText->setObjectName(QStringLiteral("fitText"));
  m_fitText->setWordWrap(true);
  m_fitText->setTextInteractionFlags(Qt::TextSelectableByMouse);
  column->addWidget(m_fitText);
  column->addStretch(1);
  auto* next = new QPushButton(tr("Go on to Compare"), content);
  next->setObjectName(QStringLiteral("goToCompare"));
  column->addWidget(next);
  connect(next, &QPushButton::clicked, this, [this] { emit goToStep(tr("Compare")); });

  auto* scroll = new QScrollArea(this);
  scroll->setWidget(content);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFixedWidth(fontMetrics().averageCharWidth() * 44);
  return scroll;
}

QWidget* FieldFitStep::makeTables() {
  m_tabs = new QTabWidget(this);
  m_tabs->setObjectName(QStringLiteral("fitTables"));
  m_tabs->setDocumentMode(true);
  const auto add = [this](const QString& name, const QString& caption) {
    auto* table = new ResultTable(m_tabs);
    table->setObjectName(name);
    table->setMinimumHeight(110);
    m_tabs->addTab(table, caption);
    return table;
  };
  m_states = add(QStringLiteral("fitStates"), tr("Before and after"));
  m_orders = add(QStringLiteral("fitOrders"), tr("Orders"));
  m_blockRows = add(QStringLiteral("fitBlocks"), tr("Blocks"));
  m_coefficients = add(QStringLiteral("fitCoefficients"), tr("Coefficients"));
  m_uncertainty = add(QStringLiteral("fitUncertainty"), tr("Uncertainty"));
  auto* copy = new QPushButton(tr("Co&py table"), m_tabs);
  copy->setObjectName(QStringLiteral("copyFitTable"));
  m_tabs->setCornerWidget(copy);
  connect(copy, &QPushButton::clicked, this, [this] {
    if (auto* table = qobject_cast<ResultTable*>(m_tabs->currentWidget())) {
      table->copy();
    }
  });
  return m_tabs;
}

void FieldFitStep::refresh() {
  m_stale = !m_shown;
  if (m_stale) {
    return;
  }
  showChoices();
  m_notices->setNotices(m_presenter.notices());
  m_fitText->setText(m_presenter.fitText());
  m_fitText->setVisible(!m_presenter.fitText().isEmpty());
  showNumbers();
  m_figures->setFigures(m_presenter.figures(), m_presenter.emptyPlot());
  m_states->setTable(m_presenter.states());
  m_orders->setTable(m_presenter.orders());
  m_blockRows->setTable(m_presenter.blockRows());
  m_coefficients->setTable(m_presenter.coefficients());
  m_uncertainty->setTable(m_presenter.uncertainty());
}

void FieldFitStep::showChoices() {
  const FieldChoices& choices = m_presenter.choices();
  const QSignalBlocker quietOrder(m_order);
  const QSignalBlocker quietMethod(m_method);
  const QSignalBlocker quietScale(m_fullScale);
  const QSignalBlocker quietReference(m_reference);
  m_order->setCurrentIndex(m_order->findData(choices.order));
  m_method->setCurrentIndex(m_method->findData(static_cast<int>(choices.method)));
  m_fullScale->setValue(choices.fullScaleT);
  m_reference->setValue(choices.referenceTemperatureC);
  const QList<FieldFitPresenter::BlockChoice> blocks = m_presenter.blocks();
  for (int i = 0; i < blocks.size(); ++i) {
    const QSignalBlocker quiet(m_blocks[i]);
    m_blocks[i]->setText(blocks[i].measured ? blocks[i].title : tr("%1 (not measured)").arg(blocks[i].title));
    m_blocks[i]->setChecked(blocks[i].on && blocks[i].measured);
    m_blocks[i]->setEnabled(blocks[i].measured);
    m_blocks[i]->setToolTip(tr("Without it: %1").arg(blocks[i].cost));
  }
}

void FieldFitStep::showNumbers() {
  const QList<FieldFitPresenter::BeforeAfter> values = m_presenter.beforeAfter();
  while (m_numberLabels.size() < values.size()) {
    auto* label = new ValueLabel({}, ValueLabel::Size::Medium, QPalette::WindowText, this);
    m_numbers->insertWidget(static_cast<int>(m_numberLabels.size()), label);
    m_numberLabels.append(label);
  }
  for (int i = 0; i < m_numberLabels.size(); ++i) {
    const bool used = i < values.size();
    m_numberLabels[i]->setVisible(used);
    if (used) {
      m_numberLabels[i]->setCaption(values[i].caption);
      m_numberLabels[i]->setText(values[i].value);
      m_numberLabels[i]->setToolTip(values[i].hint);
    }
  }
}

StepPage* makeFieldFitStep(FieldStepContext context, QWidget* parent) { return new FieldFitStep(context, parent); }

} // namespace straightedge::gui
