#include "app/gui/field_steps/field_review_step.h"

#include "app/gui/field_steps/field_page_words.h"
#include "app/gui/figures/field_figure_parts.h"
#include "app/gui/plots/scene_view.h"
#include "app/gui/steps/value_label.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTabWidget>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace straightedge::gui {

namespace {

enum StageColumn : std::uint8_t { StageTitle, StageField, StageRows, StageLocked, StageLeftOut, StageColumns };

QPushButton* fieldReviewButton(QWidget* parent, const QString& text, const QString& name, const QString& hint = {}) {
  auto* made = new QPushButton(text, parent);
  made->setObjectName(name);
  made->setToolTip(hint);
  return made;
}

Qt::CheckState checkOf(std::size_t on, std::size_t rows) {
  return on == 0 ? Qt::Unchecked : on == rows ? Qt::Checked : Qt::PartiallyChecked;
}

void fillStageItem(QTreeWidgetItem& item, const QStringList& texts, Qt::CheckState check) {
  for (int column = 0; column < StageColumns; ++column) {
    item.setText(column, texts[column]);
    if (column == StageField || column == StageRows || column == StageLocked) {
      item.setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    }
  }
  item.setFlags(item.flags() | Qt::ItemIsUserCheckable);
  item.setCheckState(StageTitle, check);
  item.setToolTip(StageLeftOut, texts[StageLeftOut]);
}

} // namespace

FieldReviewStep::FieldReviewStep(FieldStepContext context, QWidget* parent)
    : StepPage(parent), m_presenter(context.document) {
  auto* page = new QVBoxLayout(this);
  m_notices = new NoticeList(this);
  page->addWidget(m_notices);

  m_empty = new QWidget(this);
  auto* emptyLayout = new QVBoxLayout(m_empty);
  m_emptyText = new QLabel(m_empty);
  m_emptyText->setAlignment(Qt::AlignCenter);
  m_emptyText->setWordWrap(true);
  auto* capture = fieldReviewButton(m_empty, tr("Go to Capture"), QStringLiteral("goToCapture"));
  connect(capture, &QPushButton::clicked, this, [this] { emit goToStep(tr("Capture")); });
  emptyLayout->addStretch(1);
  emptyLayout->addWidget(m_emptyText);
  emptyLayout->addWidget(capture, 0, Qt::AlignHCenter);
  emptyLayout->addStretch(1);
  page->addWidget(m_empty, 1);

  m_content = new QWidget(this);
  auto* content = new QVBoxLayout(m_content);
  content->setContentsMargins(0, 0, 0, 0);
  m_facts = new QHBoxLayout;
  m_facts->setSpacing(28);
  m_facts->addStretch(1);
  content->addLayout(m_facts);
  auto* splitter = new QSplitter(Qt::Horizontal, m_content);
  splitter->addWidget(makePlot());
  splitter->addWidget(makeStages());
  splitter->setSizes({500, 590});
  splitter->setStretchFactor(0, 1);
  splitter->setChildrenCollapsible(false);
  content->addWidget(splitter, 1);
  page->addWidget(m_content, 1);

  connect(&m_presenter, &FieldReviewPresenter::changed, this, &FieldReviewStep::refresh);
  connect(&m_presenter, &FieldReviewPresenter::changed, this, &StepPage::availabilityChanged);
}

QString FieldReviewStep::title() const { return tr("Review"); }

QString FieldReviewStep::helpPage() const { return QStringLiteral("field-review"); }

QString FieldReviewStep::missing() const { return m_presenter.missing(); }

void FieldReviewStep::entered() {
  m_shown = true;
  if (m_stale) {
    refresh();
  }
}

void FieldReviewStep::left() { m_shown = false; }

QWidget* FieldReviewStep::makePlot() {
  auto* tabs = new QTabWidget(this);
  tabs->setObjectName(QStringLiteral("fieldReviewTabs"));
  tabs->setDocumentMode(true);
  auto* box = new QWidget(tabs);
  auto* layout = new QVBoxLayout(box);
  layout->setContentsMargins(0, 0, 0, 0);
  m_plot = new PlotView(box);
  m_plot->setObjectName(QStringLiteral("fieldReviewPlot"));
  auto* hint = new QLabel(tr("Shown is the step of the chosen stage. Click a point to find its plateau; Ctrl and drag "
                             "to switch rows off or on. Undo with Ctrl+Z."),
                          box);
  hint->setWordWrap(true);
  layout->addWidget(m_plot, 1);
  layout->addWidget(hint);
  connect(m_plot, &PlotView::pointClicked, this, [this](int series, int index) {
    if (const auto row = m_presenter.rowAt(series, index)) {
      selectRow(*row);
    }
  });
  connect(m_plot, &PlotView::pointsSelected, this, [this](int series, const QList<int>& indices) {
    std::vector<std::size_t> rows;
    for (const int index : indices) {
      if (const auto row = m_presenter.rowAt(series, index)) {
        rows.push_back(*row);
      }
    }
    m_presenter.toggle(rows);
  });
  m_orientations = new SceneView(tabs);
  m_orientations->setObjectName(QStringLiteral("fieldReviewOrientations"));
  m_orientations->setToolTip(tr("Drag or arrow keys turn it, the wheel or + and − zoom, double click or Home resets"));
  tabs->addTab(box, tr("Rea&dings"));
  tabs->addTab(m_orientations, tr("&Orientations covered"));
  return tabs;
}

QWidget* FieldReviewStep::makeStages() {
  auto* box = new QWidget(this);
  auto* layout = new QVBoxLayout(box);
  layout->setContentsMargins(0, 0, 0, 0);
  m_stages = new QTreeWidget(box);
  m_stages->setObjectName(QStringLiteral("stages"));
  m_stages->setHeaderLabels({tr("Stage"), tr("Field (T)"), tr("Rows"), tr("Locked"), tr("Left out")});
  for (const int column : {StageField, StageRows, StageLocked}) {
    m_stages->headerItem()->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
  }
  m_stages->setSelectionMode(QAbstractItemView::ExtendedSelection);
  m_stages->setAlternatingRowColors(true);
  m_stages->setUniformRowHeights(true);
  m_stages->setAllColumnsShowFocus(true);
  const int character = fontMetrics().averageCharWidth();
  m_stages->setColumnWidth(StageTitle, character * 33);
  m_stages->setColumnWidth(StageField, character * 12);
  m_stages->setColumnWidth(StageRows, character * 8);
  m_stages->setColumnWidth(StageLocked, character * 9);
  m_stages->header()->setStretchLastSection(true);
  m_stages->installEventFilter(this);
  connect(m_stages, &QTreeWidget::currentItemChanged, this, [this] {
    if (!m_filling) {
      showPlot();
    }
  });
  connect(m_stages, &QTreeWidget::itemSelectionChanged, this, &FieldReviewStep::showActions);
  connect(
      m_stages, &QTreeWidget::itemChanged, this,
      [this](QTreeWidgetItem* item, int column) {
        if (!m_filling && column == StageTitle) {
          const auto [stage, run] = placeOf(item);
          m_presenter.setEnabled(m_presenter.rowsOf(stage, run), item->checkState(StageTitle) == Qt::Checked,
                                 item->text(StageTitle));
        }
      },
      Qt::QueuedConnection); // the tree is filled anew: not while it tells of the change
  layout->addWidget(m_stages, 1);
  layout->addWidget(makeActions());
  return box;
}

QWidget* FieldReviewStep::makeActions() {
  auto* box = new QWidget(this);
  auto* layout = new QHBoxLayout(box);
  layout->setContentsMargins(0, 0, 0, 0);
  m_off = fieldReviewButton(box, tr("Switch o&ff"), QStringLiteral("switchOff"),
                            tr("Leaves the selected plateaus, sweeps or stages out (Delete)"));
  m_on = fieldReviewButton(box, tr("Switch o&n"), QStringLiteral("switchOn"), tr("Counts them again"));
  m_allOn = fieldReviewButton(box, tr("Switch &all on"), QStringLiteral("switchAllOn"));
  auto* copy = fieldReviewButton(box, tr("Co&py"), QStringLiteral("copyStages"),
                                 tr("Copies the list for a spreadsheet (Ctrl+C)"));
  auto* next = fieldReviewButton(box, tr("Go on to Fit"), QStringLiteral("goToFit"));
  for (QPushButton* button : {m_off, m_on, m_allOn, copy}) {
    layout->addWidget(button);
  }
  layout->addStretch(1);
  layout->addWidget(next);
  connect(m_off, &QPushButton::clicked, this, [this] { switchSelected(false); });
  connect(m_on, &QPushButton::clicked, this, [this] { switchSelected(true); });
  connect(m_allOn, &QPushButton::clicked, &m_presenter, &FieldReviewPresenter::switchAllOn);
  connect(copy, &QPushButton::clicked, this, &FieldReviewStep::copyTable);
  connect(next, &QPushButton::clicked, this, [this] { emit goToStep(tr("Fit")); });
  return box;
}

bool FieldReviewStep::eventFilter(QObject* watched, QEvent* event) {
  if (watched == m_stages && event->type() == QEvent::KeyPress) {
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
      switchSelected(false);
      return true;
    }
  }
  return StepPage::eventFilter(watched, event);
}

std::pair<std::size_t, std::optional<std::size_t>> FieldReviewStep::placeOf(QTreeWidgetItem* item) const {
  QTreeWidgetItem* parent = item->parent();
  if (parent == nullptr) {
    return {static_cast<std::size_t>(m_stages->indexOfTopLevelItem(item)), std::nullopt};
  }
  return {static_cast<std::size_t>(m_stages->indexOfTopLevelItem(parent)),
          static_cast<std::size_t>(parent->indexOfChild(item))};
}

std::vector<std::size_t> FieldReviewStep::selectedRows() const {
  std::vector<std::size_t> rows;
  for (QTreeWidgetItem* item : m_stages->selectedItems()) {
    const auto [stage, run] = placeOf(item);
    const std::vector<std::size_t> more = m_presenter.rowsOf(stage, run);
    rows.insert(rows.end(), more.begin(), more.end());
  }
  return rows;
}

QString FieldReviewStep::selectedTitle() const {
  const QList<QTreeWidgetItem*> items = m_stages->selectedItems();
  if (items.size() != 1) {
    return {};
  }
  const QTreeWidgetItem* parent = items.front()->parent();
  const QString title = items.front()->text(StageTitle);
  return parent == nullptr ? title : parent->text(StageTitle) + QStringLiteral(": ") + title.toLower();
}

void FieldReviewStep::switchSelected(bool on) { m_presenter.setEnabled(selectedRows(), on, selectedTitle()); }

void FieldReviewStep::selectRow(std::size_t row) {
  if (const auto place = m_presenter.placeOfRow(row)) {
    QTreeWidgetItem* item =
        m_stages->topLevelItem(static_cast<int>(place->first))->child(static_cast<int>(place->second));
    m_stages->setCurrentItem(item);
    m_stages->scrollToItem(item);
  }
}

void FieldReviewStep::copyTable() {
  QString text;
  const auto append = [&text](const QTreeWidgetItem& item, const QString& before) {
    text += before + item.text(StageTitle);
    for (int column = StageField; column < StageColumns; ++column) {
      text += QLatin1Char('\t') + item.text(column);
    }
    text += QLatin1Char('\n');
  };
  append(*m_stages->headerItem(), {});
  for (int stage = 0; stage < m_stages->topLevelItemCount(); ++stage) {
    const QTreeWidgetItem* top = m_stages->topLevelItem(stage);
    append(*top, {});
    for (int run = 0; run < top->childCount(); ++run) {
      append(*top->child(run), top->text(StageTitle) + QStringLiteral(": "));
    }
  }
  QGuiApplication::clipboard()->setText(text);
}

void FieldReviewStep::refresh() {
  m_stale = !m_shown;
  if (m_stale) {
    return;
  }
  const bool there = m_presenter.hasCampaign();
  m_content->setVisible(there);
  m_empty->setVisible(!there);
  m_emptyText->setText(m_presenter.missing());
  m_notices->setNotices(m_presenter.notices());
  if (there) {
    showFacts();
    showStages();
    showPlot();
    showActions();
    m_orientations->setSpec(m_presenter.orientations());
  }
}

void FieldReviewStep::showFacts() {
  const QList<FieldReviewPresenter::Fact> facts = m_presenter.facts();
  while (m_factLabels.size() < facts.size()) {
    auto* label = new ValueLabel({}, ValueLabel::Size::Medium, QPalette::WindowText, m_content);
    m_facts->insertWidget(static_cast<int>(m_factLabels.size()), label);
    m_factLabels.append(label);
  }
  for (int i = 0; i < m_factLabels.size(); ++i) {
    const bool used = i < facts.size();
    m_factLabels[i]->setVisible(used);
    if (used) {
      m_factLabels[i]->setCaption(facts[i].caption);
      m_factLabels[i]->setText(facts[i].value);
      m_factLabels[i]->setToolTip(facts[i].hint);
    }
  }
}

void FieldReviewStep::showStages() {
  const QScopedValueRollback filling(m_filling, true);
  const std::vector<ListedStage>& stages = m_presenter.stages();
  while (m_stages->topLevelItemCount() > static_cast<int>(stages.size())) {
    delete m_stages->takeTopLevelItem(m_stages->topLevelItemCount() - 1);
  }
  for (std::size_t place = 0; place < stages.size(); ++place) { // items stay, so that selection and folds stay
    const ListedStage& stage = stages[place];
    QTreeWidgetItem* top = m_stages->topLevelItem(static_cast<int>(place));
    if (top == nullptr) {
      top = new QTreeWidgetItem(m_stages);
      top->setSizeHint(StageTitle, QSize(0, fontMetrics().height() + 8)); // of all rows: they are uniform
    }
    fillStageItem(*top,
                  {stage.title, QString(), QString::number(stage.rows),
                   stage.needsLock ? QString::number(stage.locked) : QString(), stage.leftOut},
                  checkOf(stage.on, stage.rows));
    while (top->childCount() > static_cast<int>(stage.runs.size())) {
      delete top->takeChild(top->childCount() - 1);
    }
    for (std::size_t run = 0; run < stage.runs.size(); ++run) {
      const ListedRun& listed = stage.runs[run];
      QTreeWidgetItem* item = top->child(static_cast<int>(run));
      if (item == nullptr) {
        item = new QTreeWidgetItem(top);
      }
      fillStageItem(*item,
                    {listed.title,
                     std::isfinite(listed.run.referenceT) ? peopleNumber(listed.run.referenceT, 5) : QString(),
                     QString::number(listed.run.count),
                     stage.needsLock ? QString::number(listed.run.locked) : QString(), listed.leftOut},
                    checkOf(listed.on, listed.run.count));
    }
  }
  if (m_stages->currentItem() == nullptr && m_stages->topLevelItemCount() > 0) {
    m_stages->setCurrentItem(m_stages->topLevelItem(0));
  }
}

void FieldReviewStep::showPlot() {
  QTreeWidgetItem* item = m_stages->currentItem();
  if (item == nullptr || !m_presenter.hasCampaign()) {
    return;
  }
  const std::size_t stage = placeOf(item).first;
  if (stage < m_presenter.stages().size()) {
    m_plot->setSpec(m_presenter.plot(m_presenter.stages()[stage].step));
  }
}

void FieldReviewStep::showActions() {
  const bool selected = !m_stages->selectedItems().isEmpty();
  m_off->setEnabled(selected);
  m_on->setEnabled(selected);
  m_allOn->setEnabled(m_presenter.anyOff());
}

StepPage* makeFieldReviewStep(FieldStepContext context, QWidget* parent) {
  return new FieldReviewStep(context, parent);
}

} // namespace straightedge::gui
