#include "app/gui/steps/review_step.h"

#include "app/gui/steps/value_label.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QTabBar>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>
#include <numeric>

namespace straightedge::gui {

namespace {

constexpr int factColumns = 8;

QPushButton* reviewButton(QWidget* parent, const QString& text, const QString& name, const QString& hint = {}) {
  auto* made = new QPushButton(text, parent);
  made->setObjectName(name);
  made->setToolTip(hint);
  return made;
}

} // namespace

ReviewStep::ReviewStep(StepContext context, QWidget* parent)
    : StepPage(parent), m_presenter(context.document, context.jobs) {
  auto* page = new QVBoxLayout(this);
  m_notices = new NoticeList(this);
  page->addWidget(m_notices);

  m_empty = new QWidget(this);
  auto* emptyLayout = new QVBoxLayout(m_empty);
  m_emptyText = new QLabel(m_empty);
  m_emptyText->setAlignment(Qt::AlignCenter);
  m_emptyText->setWordWrap(true);
  auto* capture = reviewButton(m_empty, tr("Go to Capture"), QStringLiteral("goToCapture"));
  connect(capture, &QPushButton::clicked, this, [this] { emit goToStep(tr("Capture")); });
  emptyLayout->addStretch(1);
  emptyLayout->addWidget(m_emptyText);
  emptyLayout->addWidget(capture, 0, Qt::AlignHCenter);
  emptyLayout->addStretch(1);
  page->addWidget(m_empty, 1);

  m_content = new QWidget(this);
  auto* content = new QVBoxLayout(m_content);
  content->setContentsMargins(0, 0, 0, 0);
  m_facts = new QGridLayout;
  m_facts->setHorizontalSpacing(24);
  content->addLayout(m_facts);
  auto* splitter = new QSplitter(Qt::Horizontal, m_content);
  splitter->addWidget(makePlots());
  splitter->addWidget(makeTable());
  splitter->setSizes({520, 570});
  splitter->setStretchFactor(0, 1);
  splitter->setChildrenCollapsible(false);
  content->addWidget(splitter, 1);
  page->addWidget(m_content, 1);

  connect(&m_presenter, &ReviewPresenter::analysisChanged, this, &ReviewStep::showAnalysis);
  connect(&m_presenter, &ReviewPresenter::plotsChanged, this, &ReviewStep::showPlot);
  connect(&m_presenter, &ReviewPresenter::missingChanged, this, &StepPage::availabilityChanged);
  showAnalysis();
}

QString ReviewStep::title() const { return tr("Review"); }

QString ReviewStep::helpPage() const { return QStringLiteral("review"); }

QString ReviewStep::missing() const { return m_presenter.missing(); }

void ReviewStep::entered() {
  m_shown = true;
  showAnalysis();
}

void ReviewStep::left() { m_shown = false; }

QWidget* ReviewStep::makePlots() {
  auto* box = new QWidget(this);
  auto* layout = new QVBoxLayout(box);
  layout->setContentsMargins(0, 0, 0, 0);
  m_views = new QTabBar(box);
  m_views->setObjectName(QStringLiteral("reviewViews"));
  m_views->setDrawBase(false);
  m_views->setExpanding(false);
  for (const QString& name :
       {tr("Error"), tr("Unwrapped"), tr("Residual"), tr("Hysteresis"), tr("Noise"), tr("Coverage")}) {
    m_views->addTab(name);
  }
  m_plot = new PlotView(box);
  m_plot->setObjectName(QStringLiteral("reviewPlot"));
  m_hint = new QLabel(tr("Click a point to switch it off or on. Ctrl and drag for several. Undo with Ctrl+Z."), box);
  m_hint->setWordWrap(true);
  layout->addWidget(m_views);
  layout->addWidget(m_plot, 1);
  layout->addWidget(m_hint);
  connect(m_views, &QTabBar::currentChanged, this, &ReviewStep::showPlot);
  connectPlot();
  return box;
}

void ReviewStep::connectPlot() {
  connect(m_plot, &PlotView::pointClicked, this, [this](int series, int index) {
    if (const auto row = m_presenter.rowAt(view(), series, index)) {
      selectRows({*row});
      m_presenter.toggle({*row});
    }
  });
  connect(m_plot, &PlotView::pointsSelected, this, [this](int series, const QList<int>& indices) {
    std::vector<std::size_t> rows;
    for (const int index : indices) {
      if (const auto row = m_presenter.rowAt(view(), series, index)) {
        rows.push_back(*row);
      }
    }
    if (!rows.empty()) {
      selectRows(rows);
      m_presenter.toggle(rows);
    }
  });
}

QWidget* ReviewStep::makeTable() {
  auto* box = new QWidget(this);
  auto* layout = new QVBoxLayout(box);
  layout->setContentsMargins(0, 0, 0, 0);
  m_table = new QTableView(box);
  m_table->setObjectName(QStringLiteral("reviewTable"));
  m_table->setModel(&m_presenter.table());
  m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
  m_table->setSelectionMode(QAbstractItemView::ExtendedSelection);
  m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  m_table->setAlternatingRowColors(true);
  m_table->setShowGrid(false);
  m_table->setWordWrap(false);
  m_table->verticalHeader()->hide();
  // A fixed height keeps 100,000 rows as quick as 10.
  m_table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  m_table->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 8);
  m_table->horizontalHeader()->setStretchLastSection(true);
  m_table->horizontalHeader()->setHighlightSections(false);
  const int character = fontMetrics().averageCharWidth();
  for (int column = 0; column < ReviewTableModel::Remark; ++column) {
    const bool angle = column >= ReviewTableModel::Encoder;
    m_table->setColumnWidth(column, character * (angle ? 12 : column == ReviewTableModel::Turn ? 7 : 11));
  }
  m_table->installEventFilter(this);
  connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
    m_presenter.setSelection(selectedRows());
    showActions();
  });
  layout->addWidget(m_table, 1);
  layout->addWidget(makeActions());
  return box;
}

QWidget* ReviewStep::makeActions() {
  auto* box = new QWidget(this);
  auto* layout = new QGridLayout(box);
  layout->setContentsMargins(0, 0, 0, 0);
  m_off =
      reviewButton(box, tr("Switch o&ff"), QStringLiteral("switchOff"), tr("Leaves the selected rows out (Delete)"));
  m_on = reviewButton(box, tr("Switch o&n"), QStringLiteral("switchOn"), tr("Counts the selected rows again"));
  m_selectOutliers = reviewButton(box, tr("Select &outliers"), QStringLiteral("selectOutliers"));
  m_allOn = reviewButton(box, tr("Switch &all on"), QStringLiteral("switchAllOn"));
  m_copy = reviewButton(box, tr("&Copy"), QStringLiteral("copyTable"),
                        tr("Copies the selected rows, or all, for a spreadsheet (Ctrl+C)"));
  m_next = reviewButton(box, tr("Go on to Fit"), QStringLiteral("goToFit"));
  layout->addWidget(m_off, 0, 0);
  layout->addWidget(m_on, 0, 1);
  layout->addWidget(m_selectOutliers, 0, 2);
  layout->addWidget(m_allOn, 1, 0);
  layout->addWidget(m_copy, 1, 1);
  layout->addWidget(m_next, 1, 2);
  connect(m_off, &QPushButton::clicked, this, [this] { m_presenter.setEnabled(selectedRows(), false); });
  connect(m_on, &QPushButton::clicked, this, [this] { m_presenter.setEnabled(selectedRows(), true); });
  connect(m_selectOutliers, &QPushButton::clicked, this, [this] { selectRows(m_presenter.outliers()); });
  connect(m_allOn, &QPushButton::clicked, &m_presenter, &ReviewPresenter::switchAllOn);
  connect(m_copy, &QPushButton::clicked, this, &ReviewStep::copyTable);
  connect(m_next, &QPushButton::clicked, this, [this] { emit goToStep(tr("Fit")); });
  return box;
}

bool ReviewStep::eventFilter(QObject* watched, QEvent* event) {
  if (watched == m_table && event->type() == QEvent::KeyPress) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->matches(QKeySequence::Copy)) {
      copyTable();
      return true;
    }
    if (key->key() == Qt::Key_Space) {
      m_presenter.toggle(selectedRows());
      return true;
    }
    if (key->key() == Qt::Key_Delete) {
      m_presenter.setEnabled(selectedRows(), false);
      return true;
    }
  }
  return StepPage::eventFilter(watched, event);
}

ReviewPresenter::View ReviewStep::view() const { return static_cast<ReviewPresenter::View>(m_views->currentIndex()); }

std::vector<std::size_t> ReviewStep::selectedRows() const {
  std::vector<std::size_t> rows;
  for (const QItemSelectionRange& range : m_table->selectionModel()->selection()) {
    for (int row = range.top(); row <= range.bottom(); ++row) {
      rows.push_back(static_cast<std::size_t>(row));
    }
  }
  std::ranges::sort(rows);
  rows.erase(std::ranges::unique(rows).begin(), rows.end());
  return rows;
}

void ReviewStep::selectRows(const std::vector<std::size_t>& rows) {
  QItemSelection selection;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::size_t last = i; // neighbours in one range: a selection of thousands stays quick
    while (last + 1 < rows.size() && rows[last + 1] == rows[last] + 1) {
      ++last;
    }
    selection.select(m_presenter.table().index(static_cast<int>(rows[i]), 0),
                     m_presenter.table().index(static_cast<int>(rows[last]), ReviewTableModel::ColumnCount - 1));
    i = last;
  }
  m_table->selectionModel()->select(selection, QItemSelectionModel::ClearAndSelect);
  if (!rows.empty()) {
    m_table->scrollTo(m_presenter.table().index(static_cast<int>(rows.front()), 0));
  }
}

void ReviewStep::copyTable() {
  std::vector<std::size_t> rows = selectedRows();
  if (rows.empty()) {
    rows.resize(static_cast<std::size_t>(m_presenter.table().rowCount()));
    std::iota(rows.begin(), rows.end(), std::size_t{0});
  }
  QGuiApplication::clipboard()->setText(m_presenter.table().asText(rows));
}

void ReviewStep::showAnalysis() {
  const bool sweep = m_presenter.hasSweep();
  m_content->setVisible(sweep);
  m_empty->setVisible(!sweep);
  m_emptyText->setText(m_presenter.missing());
  m_notices->setNotices(m_presenter.notices());
  if (!m_shown) {
    return; // built when somebody looks
  }
  for (const auto column : {ReviewTableModel::Turn, ReviewTableModel::Direction}) {
    m_table->setColumnHidden(column, m_presenter.table().isUniform(column));
  }
  showFacts();
  showPlot();
  showActions();
}

void ReviewStep::showFacts() {
  const QList<ReviewPresenter::Fact> facts = m_presenter.facts();
  while (m_factLabels.size() < static_cast<std::size_t>(facts.size())) {
    auto* label = new ValueLabel({}, ValueLabel::Size::Medium, QPalette::WindowText, m_content);
    const int place = static_cast<int>(m_factLabels.size());
    m_facts->addWidget(label, place / factColumns, place % factColumns, Qt::AlignLeft);
    m_factLabels.push_back(label);
  }
  for (std::size_t i = 0; i < m_factLabels.size(); ++i) {
    const bool used = i < static_cast<std::size_t>(facts.size());
    m_factLabels[i]->setVisible(used);
    if (used) {
      const ReviewPresenter::Fact& fact = facts[static_cast<qsizetype>(i)];
      m_factLabels[i]->setCaption(fact.caption);
      m_factLabels[i]->setText(fact.value);
      m_factLabels[i]->setToolTip(fact.hint);
    }
  }
}

void ReviewStep::showPlot() {
  if (!m_shown || !m_presenter.hasSweep()) {
    return;
  }
  m_plot->setSpec(m_presenter.plot(view()));
  using View = ReviewPresenter::View;
  m_hint->setVisible(view() == View::Error || view() == View::Residual || view() == View::Unwrapped);
}

void ReviewStep::showActions() {
  const bool selected = !selectedRows().empty();
  m_off->setEnabled(selected);
  m_on->setEnabled(selected);
  m_selectOutliers->setEnabled(!m_presenter.outliers().empty());
  m_allOn->setEnabled(m_presenter.switchedOff() > 0);
}

StepPage* makeReviewStep(StepContext context, QWidget* parent) { return new ReviewStep(context, parent); }

} // namespace straightedge::gui
