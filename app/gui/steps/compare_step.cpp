#include "app/gui/steps/compare_step.h"

#include "app/gui/figures/figure_parts.h"
#include "app/gui/steps/comparison_table.h"
#include "app/gui/steps/notice_list.h"

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QGroupBox>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QShortcut>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QTabWidget>
#include <QTableView>
#include <QVBoxLayout>

namespace straightedge::gui {

namespace {

/// By the longest text that can occur: measuring thousands of rows after every change would take too long.
void setColumnWidths(QTableView& table) {
  const QAbstractItemModel& model = *table.model();
  const QFontMetrics metrics = table.fontMetrics();
  const int padding = 5 * metrics.averageCharWidth(); // margins and the arrow of the sorted column
  for (int c = 0; c < model.columnCount(); ++c) {
    QString widest = model.headerData(c, Qt::Horizontal).toString();
    if (c == ComparisonTable::Model) {
      widest = modelNameText({angle::ModelKind::LookupTable, 1024, angle::FitMethod::MidRange, {}});
    } else if (c == ComparisonTable::Method) {
      widest = methodTitle(angle::ModelKind::LookupTable, angle::FitMethod::MidRange);
    }
    table.setColumnWidth(c, metrics.horizontalAdvance(widest) + padding);
  }
}

} // namespace

CompareStep::CompareStep(StepContext context, QWidget* parent)
    : StepPage(parent), m_presenter(context.document, context.jobs) {
  auto* page = new QVBoxLayout(this);
  m_notices = new NoticeList(this);
  page->addWidget(m_notices);
  page->addWidget(makeAnswers());
  page->addWidget(makeOptions());
  m_tabs = new QTabWidget(this);
  m_tabs->setDocumentMode(true);
  m_plot = new PlotView(m_tabs);
  m_plot->setObjectName(QStringLiteral("comparisonPlot"));
  m_plot->setMinimumHeight(240);
  m_tabs->addTab(m_plot, tr("Plot"));
  m_tabs->addTab(makeTable(), tr("Table"));
  page->addWidget(m_tabs, 1);

  connect(m_plot, &PlotView::guideDragged, &m_presenter, &ComparePresenter::dragGuide);
  connect(m_plot, &PlotView::guideDropped, &m_presenter, &ComparePresenter::dragGuide);
  connect(m_plot, &PlotView::pointClicked, &m_presenter, &ComparePresenter::choosePoint);
  connect(&m_presenter, &ComparePresenter::figureChanged, this, &CompareStep::showFigure);
  connect(&m_presenter, &ComparePresenter::figureChanged, this, &StepPage::availabilityChanged);
  connect(&m_presenter, &ComparePresenter::demandsChanged, this, &CompareStep::showDemands);
  connect(&m_presenter, &ComparePresenter::progressChanged, this,
          [this] { m_progress->setText(m_presenter.progressText()); });
}

QString CompareStep::title() const { return tr("Compare"); }

QString CompareStep::helpPage() const { return QStringLiteral("compare"); }

QString CompareStep::missing() const { return m_presenter.missing(); }

void CompareStep::entered() {
  m_shown = true;
  if (m_stale) {
    showFigure();
  }
  showDemands();
}

void CompareStep::left() { m_shown = false; }

QWidget* CompareStep::makeAnswers() {
  auto* box = new QGroupBox(tr("Which model?"), this);
  auto* grid = new QGridLayout(box);
  grid->setColumnStretch(2, 1);
  grid->setHorizontalSpacing(12);
  m_target = new QDoubleSpinBox(box);
  m_target->setObjectName(QStringLiteral("targetError"));
  m_target->setDecimals(4);
  m_target->setRange(0.0001, 180.0);
  m_target->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  m_target->setSuffix(QStringLiteral("°"));
  m_target->setKeyboardTracking(false);
  m_budget = new QSpinBox(box);
  m_budget->setObjectName(QStringLiteral("budgetEntries"));
  m_budget->setRange(1, 4096);
  m_budget->setSuffix(tr(" entries"));
  m_budget->setKeyboardTracking(false);
  const auto row = [&](int index, const QString& caption, QWidget* field, QLabel*& answer, QPushButton*& take,
                       const QString& name) {
    auto* label = new QLabel(caption, box);
    label->setBuddy(field);
    answer = new QLabel(box);
    answer->setObjectName(name + QStringLiteral("Answer"));
    answer->setWordWrap(true);
    answer->setTextInteractionFlags(Qt::TextSelectableByMouse);
    take = new QPushButton(tr("Use it"), box);
    take->setObjectName(name + QStringLiteral("Use"));
    take->setToolTip(tr("Fit shows this model and Verify uses it"));
    grid->addWidget(label, index, 0, Qt::AlignTop);
    grid->addWidget(field, index, 1, Qt::AlignTop);
    grid->addWidget(answer, index, 2);
    grid->addWidget(take, index, 3, Qt::AlignTop);
  };
  row(0, tr("&Target error"), m_target, m_targetAnswer, m_takeTarget, QStringLiteral("target"));
  row(1, tr("Storage &budget"), m_budget, m_budgetAnswer, m_takeBudget, QStringLiteral("budget"));
  m_chosen = new QLabel(box);
  m_chosen->setObjectName(QStringLiteral("chosenModel"));
  m_chosen->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_chosen->setWordWrap(true);
  auto* next = new QPushButton(tr("Go on to Verify"), box);
  next->setObjectName(QStringLiteral("goToVerify"));
  grid->addWidget(m_chosen, 2, 0, 1, 3);
  grid->addWidget(next, 2, 3);
  connect(m_target, &QDoubleSpinBox::valueChanged, &m_presenter, &ComparePresenter::setTargetErrorDeg);
  connect(m_budget, &QSpinBox::valueChanged, &m_presenter, &ComparePresenter::setBudgetEntries);
  connect(m_takeTarget, &QPushButton::clicked, this, [this] {
    if (const angle::Recommendation answer = m_presenter.forTarget(); answer.choice) {
      m_presenter.chooseModel(answer.choice->name);
    }
  });
  connect(m_takeBudget, &QPushButton::clicked, this, [this] {
    if (const angle::Recommendation answer = m_presenter.forBudget(); answer.choice) {
      m_presenter.chooseModel(answer.choice->name);
    }
  });
  connect(next, &QPushButton::clicked, this, [this] { emit goToStep(tr("Verify")); });
  return box;
}

QWidget* CompareStep::makeOptions() {
  auto* bar = new QWidget(this);
  auto* layout = new QHBoxLayout(bar);
  layout->setContentsMargins(0, 0, 0, 0);
  const auto choice = [&](const QString& caption, const QString& name) {
    auto* box = new QComboBox(bar);
    box->setObjectName(name);
    auto* label = new QLabel(caption, bar);
    label->setBuddy(box);
    layout->addWidget(label);
    layout->addWidget(box);
    layout->addSpacing(12);
    return box;
  };
  QComboBox* error = choice(tr("&Error"), QStringLiteral("errorMeasure"));
  error->addItem(tr("maximum"), static_cast<int>(ErrorMeasure::Maximum));
  error->addItem(tr("rms"), static_cast<int>(ErrorMeasure::Rms));
  QComboBox* storage = choice(tr("&Storage in"), QStringLiteral("storageMeasure"));
  storage->addItem(tr("entries"), static_cast<int>(StorageMeasure::Entries));
  storage->addItem(tr("bytes"), static_cast<int>(StorageMeasure::Bytes));
  QComboBox* bits = choice(tr("Stored &as"), QStringLiteral("storedBits"));
  bits->addItem(tr("float, 4 bytes"), 0);
  for (int width = 16; width >= 8; --width) {
    bits->addItem(tr("integers, %1 bit").arg(width), width);
  }
  layout->addStretch(1);
  m_progress = new QLabel(bar);
  m_progress->setObjectName(QStringLiteral("comparisonProgress"));
  layout->addWidget(m_progress);
  connect(error, &QComboBox::currentIndexChanged, this,
          [this, error] { m_presenter.setErrorMeasure(static_cast<ErrorMeasure>(error->currentData().toInt())); });
  connect(storage, &QComboBox::currentIndexChanged, this, [this, storage] {
    m_presenter.setStorageMeasure(static_cast<StorageMeasure>(storage->currentData().toInt()));
  });
  connect(bits, &QComboBox::activated, this, [this, bits] {
    const int width = bits->currentData().toInt();
    m_presenter.setBits(width > 0 ? std::optional(width) : std::nullopt);
  });
  connect(&m_presenter, &ComparePresenter::figureChanged, bits, [this, bits] {
    const QSignalBlocker quiet(bits);
    bits->setCurrentIndex(bits->findData(m_presenter.bits().value_or(0)));
  });
  return bar;
}

QWidget* CompareStep::makeTable() {
  auto* area = new QWidget(this);
  auto* layout = new QVBoxLayout(area);
  auto* bar = new QHBoxLayout;
  auto* method = new QComboBox(area);
  method->setObjectName(QStringLiteral("methodFilter"));
  using Method = std::pair<angle::ModelKind, angle::FitMethod>;
  const QList<Method> methods{{angle::ModelKind::Harmonic, angle::FitMethod::ByAmplitude},
                              {angle::ModelKind::Linear, angle::FitMethod::LeastSquares},
                              {angle::ModelKind::Linear, angle::FitMethod::OnCurve},
                              {angle::ModelKind::Linear, angle::FitMethod::Minimax},
                              {angle::ModelKind::LookupTable, angle::FitMethod::Mean},
                              {angle::ModelKind::LookupTable, angle::FitMethod::MidRange}};
  method->addItem(tr("All methods"));
  for (const Method& each : methods) {
    method->addItem(methodTitle(each.first, each.second));
  }
  auto* all = new QCheckBox(tr("Every size"), area);
  all->setObjectName(QStringLiteral("everySize"));
  all->setToolTip(tr("Otherwise only 1, 2, 4, 8, …"));
  auto* copy = new QPushButton(tr("Co&py table"), area);
  copy->setObjectName(QStringLiteral("copyComparison"));
  bar->addWidget(method);
  bar->addWidget(all);
  bar->addStretch(1);
  bar->addWidget(copy);
  layout->addLayout(bar);
  m_rows = new ComparisonTable(this);
  m_filter = new ComparisonFilter(this);
  m_filter->setSourceModel(m_rows);
  m_table = new QTableView(area);
  m_table->setObjectName(QStringLiteral("comparisonRows"));
  m_table->setModel(m_filter);
  m_table->setSortingEnabled(true);
  m_table->sortByColumn(-1, Qt::AscendingOrder);
  m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
  m_table->setAlternatingRowColors(true);
  m_table->setShowGrid(false);
  m_table->verticalHeader()->setVisible(false);
  m_table->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 10);
  m_table->horizontalHeader()->setHighlightSections(false);
  setColumnWidths(*m_table);
  layout->addWidget(m_table, 1);
  connect(method, &QComboBox::currentIndexChanged, this, [this, methods](int index) {
    m_filter->setMethod(index > 0 ? std::optional(methods[index - 1]) : std::nullopt);
  });
  connect(all, &QCheckBox::toggled, this, [this](bool on) { m_filter->setPowersOnly(!on); });
  connect(copy, &QPushButton::clicked, this, &CompareStep::copyTable);
  connect(new QShortcut(QKeySequence::Copy, m_table, nullptr, nullptr, Qt::WidgetShortcut), &QShortcut::activated, this,
          &CompareStep::copyTable);
  connect(m_table, &QTableView::doubleClicked, this, [this](const QModelIndex& index) {
    m_presenter.chooseModel(m_rows->row(m_filter->mapToSource(index).row()).name);
  });
  return area;
}

void CompareStep::copyTable() {
  QList<int> rows;
  for (const QModelIndex& index : m_table->selectionModel()->selectedRows()) {
    rows.append(index.row());
  }
  std::ranges::sort(rows);
  QGuiApplication::clipboard()->setText(m_filter->text(rows));
}

void CompareStep::showFigure() {
  m_stale = !m_shown;
  if (m_stale) {
    return;
  }
  m_plot->setSpec(m_presenter.figure());
  m_rows->setComparison(m_presenter.comparison());
  const QString missing = m_presenter.missing();
  m_notices->setNotices(missing.isEmpty() ? QList<Notice>{} : QList<Notice>{{Notice::Level::Information, missing}});
  m_progress->setText(m_presenter.progressText());
}

void CompareStep::showDemands() {
  if (!m_shown) {
    return;
  }
  {
    const QSignalBlocker quietTarget(m_target);
    const QSignalBlocker quietBudget(m_budget);
    m_target->setValue(m_presenter.targetErrorDeg());
    m_budget->setValue(m_presenter.budgetEntries());
  }
  for (const char* id : {targetGuide, budgetGuide}) {
    const QString guide = QString::fromLatin1(id);
    m_plot->setGuideValue(guide, m_presenter.guideValue(guide));
  }
  const angle::Recommendation target = m_presenter.forTarget();
  m_targetAnswer->setText(fromText(target.sentence));
  m_takeTarget->setEnabled(target.choice.has_value());
  const angle::Recommendation budget = m_presenter.forBudget();
  m_budgetAnswer->setText(fromText(budget.sentence));
  m_takeBudget->setEnabled(budget.choice.has_value());
  m_chosen->setText(m_presenter.chosenText());
}

StepPage* makeCompareStep(StepContext context, QWidget* parent) { return new CompareStep(context, parent); }

} // namespace straightedge::gui
