#include "app/gui/field_steps/stage_list.h"

#include "app/gui/steps/step_colors.h"

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <optional>
#include <utility>

namespace straightedge::gui {

namespace {

enum ListColumn : std::uint8_t { ListStage, ListState, ListTime, ListAttempt, ListWhy };

std::optional<StepColor> colorOfProgress(StageProgress progress) {
  switch (progress) {
  case StageProgress::Measuring:
    return StepColor::Sensor;
  case StageProgress::Done:
    return StepColor::Good;
  case StageProgress::DoneInPart:
    return StepColor::Warning;
  case StageProgress::LeftOut:
    return StepColor::Quiet;
  case StageProgress::ToDo:
  case StageProgress::Begun:
    break;
  }
  return std::nullopt;
}

void setTextIfNew(QTreeWidgetItem& item, int column, const QString& text) {
  if (item.text(column) != text) {
    item.setText(column, text);
  }
}

} // namespace

StageList::StageList(QWidget* parent) : QWidget(parent), m_tree(new QTreeWidget(this)), m_detail(new QLabel(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  m_tree->setObjectName(QStringLiteral("captureStages"));
  m_tree->setHeaderLabels({tr("Stage"), tr("State"), tr("Still takes"), tr("Attempt"), tr("Why")});
  m_tree->headerItem()->setToolTip(ListTime, tr("Expected on a bench in real time, without your own handling"));
  m_tree->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff); // the last column is elided instead
  m_tree->setRootIsDecorated(false);
  m_tree->setUniformRowHeights(true);
  m_tree->setAllColumnsShowFocus(true);
  m_tree->setAlternatingRowColors(true);
  m_tree->setSelectionMode(QAbstractItemView::ExtendedSelection);
  m_tree->setContextMenuPolicy(Qt::ActionsContextMenu);
  m_tree->setMinimumHeight(m_tree->fontMetrics().height() * 7);
  const int character = fontMetrics().averageCharWidth();
  for (const auto& [column, characters] :
       {std::pair{ListStage, 29}, {ListState, 26}, {ListTime, 14}, {ListAttempt, 9}}) {
    m_tree->setColumnWidth(column, character * characters);
  }
  m_tree->header()->setStretchLastSection(true);
  layout->addWidget(m_tree, 1);
  m_detail->setObjectName(QStringLiteral("stageDetail"));
  m_detail->setWordWrap(true);
  m_detail->setTextFormat(Qt::PlainText);
  m_detail->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_detail->setMinimumHeight(fontMetrics().lineSpacing() * 3); // the plots below do not jump from stage to stage
  m_detail->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  makeActions();
  auto* foot = new QHBoxLayout;
  foot->addWidget(m_detail, 1);
  auto* buttons = new QVBoxLayout;
  buttons->addWidget(m_repeatButton);
  buttons->addWidget(m_outButton);
  buttons->addStretch(1);
  foot->addLayout(buttons);
  layout->addLayout(foot);

  connect(m_tree, &QTreeWidget::currentItemChanged, this, [this] {
    showDetail();
    emit chosen(current());
  });
  connect(m_tree, &QTreeWidget::itemSelectionChanged, this, &StageList::selectionChanged);
}

void StageList::makeActions() {
  const auto action = [this](const QString& text, const QKeySequence& key) {
    auto* made = new QAction(text, m_tree);
    made->setShortcut(key);
    made->setShortcutContext(Qt::WidgetShortcut);
    m_tree->addAction(made);
    return made;
  };
  m_repeat = action(tr("&Repeat"), QKeySequence(Qt::Key_F5));
  m_out = action(tr("&Leave out"), QKeySequence(Qt::Key_Delete));
  m_in = action(tr("Take back &in"), QKeySequence(Qt::Key_Insert));
  connect(m_repeat, &QAction::triggered, this, [this] {
    if (current() >= 0) {
      emit repeatWanted(current());
    }
  });
  connect(m_out, &QAction::triggered, this, [this] { leaveOut(true); });
  connect(m_in, &QAction::triggered, this, [this] { leaveOut(false); });

  m_repeatButton = new QPushButton(tr("&Repeat"), this);
  m_repeatButton->setObjectName(QStringLiteral("repeatStage"));
  m_repeatButton->setToolTip(tr("Measures the chosen stage again; what it gave before stays stored and does not count "
                                "any more (F5)"));
  m_outButton = new QPushButton(this);
  m_outButton->setObjectName(QStringLiteral("leaveOutStage"));
  m_outButton->setToolTip(tr("Leaves the chosen stages out (Delete), or takes them back in (Insert); rows that are "
                             "there stay"));
  connect(m_repeatButton, &QPushButton::clicked, m_repeat, &QAction::trigger);
  connect(m_outButton, &QPushButton::clicked, this, [this] { leaveOut(wouldLeaveOut()); });
  setRights(false, false);
}

void StageList::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) {
    setStages(m_lines); // colours are the theme's
  }
}

void StageList::setStages(std::vector<StageLine> stages) {
  m_lines = std::move(stages);
  const auto count = static_cast<int>(m_lines.size());
  while (m_tree->topLevelItemCount() > count) {
    delete m_tree->takeTopLevelItem(m_tree->topLevelItemCount() - 1);
  }
  for (int i = 0; i < count; ++i) {
    QTreeWidgetItem* item = m_tree->topLevelItem(i);
    if (item == nullptr) {
      item = new QTreeWidgetItem(m_tree);
      item->setSizeHint(ListStage, QSize(0, fontMetrics().height() + 8)); // of all rows: they are uniform
    }
    fill(*item, m_lines[static_cast<std::size_t>(i)]);
  }
  showDetail();
}

void StageList::fill(QTreeWidgetItem& item, const StageLine& line) {
  setTextIfNew(item, ListStage, line.title);
  setTextIfNew(item, ListState, line.state);
  setTextIfNew(item, ListTime, line.duration);
  setTextIfNew(item, ListAttempt, line.attempt);
  setTextIfNew(item, ListWhy, line.why);
  item.setToolTip(ListWhy, line.why);
  const std::optional<StepColor> color = colorOfProgress(line.progress);
  const QBrush brush(color ? stepColor(*this, *color) : palette().color(QPalette::Text));
  QFont font = m_tree->font();
  font.setBold(line.progress == StageProgress::Measuring);
  for (const ListColumn column : {ListStage, ListState}) {
    if (item.font(column) != font) {
      item.setFont(column, font);
    }
    const QBrush wanted = column == ListState || line.progress == StageProgress::LeftOut
                              ? brush
                              : QBrush(palette().color(QPalette::Text));
    if (item.foreground(column) != wanted) {
      item.setForeground(column, wanted);
    }
  }
}

void StageList::setRights(bool mayRepeat, bool mayLeaveOut) {
  m_mayLeaveOut = mayLeaveOut;
  const bool out = wouldLeaveOut();
  m_repeat->setEnabled(mayRepeat);
  m_repeatButton->setEnabled(mayRepeat);
  m_out->setEnabled(mayLeaveOut && out);
  const QList<int> chosenStages = selected();
  m_in->setEnabled(mayLeaveOut && std::ranges::any_of(chosenStages, [this](int stage) {
                     return m_lines[static_cast<std::size_t>(stage)].progress == StageProgress::LeftOut;
                   }));
  m_outButton->setText(out || chosenStages.isEmpty() ? tr("&Leave out") : tr("Take back &in"));
  m_outButton->setEnabled(mayLeaveOut && !chosenStages.isEmpty());
}

int StageList::current() const {
  QTreeWidgetItem* item = m_tree->currentItem();
  return item == nullptr ? -1 : m_tree->indexOfTopLevelItem(item);
}

void StageList::setCurrent(int stage) {
  if (QTreeWidgetItem* item = m_tree->topLevelItem(stage); item != nullptr && item != m_tree->currentItem()) {
    m_tree->setCurrentItem(item);
    m_tree->scrollToItem(item, QAbstractItemView::PositionAtCenter); // what comes next is in sight
  }
}

QList<int> StageList::selected() const {
  QList<int> stages;
  const QList<QTreeWidgetItem*> items = m_tree->selectedItems();
  for (QTreeWidgetItem* item : items) {
    stages << m_tree->indexOfTopLevelItem(item);
  }
  std::ranges::sort(stages);
  return stages;
}

bool StageList::wouldLeaveOut() const {
  const QList<int> stages = selected();
  return std::ranges::any_of(stages, [this](int stage) {
    return m_lines[static_cast<std::size_t>(stage)].progress != StageProgress::LeftOut;
  });
}

void StageList::leaveOut(bool out) {
  if (m_mayLeaveOut && !selected().isEmpty()) {
    emit leaveOutWanted(selected(), out);
  }
}

void StageList::showDetail() {
  const int stage = current();
  if (stage < 0 || static_cast<std::size_t>(stage) >= m_lines.size()) {
    m_detail->clear();
    return;
  }
  const StageLine& line = m_lines[static_cast<std::size_t>(stage)];
  const QString text = line.progress == StageProgress::LeftOut ? line.cost : line.why + QLatin1Char('\n') + line.cost;
  if (m_detail->text() != text) {
    m_detail->setText(text);
  }
}

} // namespace straightedge::gui
