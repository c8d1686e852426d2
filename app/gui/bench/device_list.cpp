#include "app/gui/bench/device_list.h"

#include "app/gui/bench/bench_colors.h"

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMimeData>
#include <QPainter>
#include <QStyledItemDelegate>

namespace straightedge::gui {

namespace {

enum DeviceData { TitleData = Qt::UserRole, LineData, ProblemData, UsefulData, KeyData };

constexpr int rowMargin = 6;

/// Title, a line on what it is used for, and a line on what is in the way.
class DeviceDelegate : public QStyledItemDelegate {
public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const int lines = index.data(ProblemData).toString().isEmpty() ? 2 : 3;
    return {200, option.fontMetrics.lineSpacing() * lines + 2 * rowMargin};
  }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    QStyleOptionViewItem ground = option;
    initStyleOption(&ground, index);
    ground.text.clear();
    const QWidget* view = option.widget;
    view->style()->drawControl(QStyle::CE_ItemViewItem, &ground, painter, view);
    const bool selected = option.state.testFlag(QStyle::State_Selected);
    const QColor bright = option.palette.color(QPalette::HighlightedText);
    QRect line = option.rect.adjusted(rowMargin + 2, rowMargin, -rowMargin, -rowMargin);
    line.setHeight(option.fontMetrics.lineSpacing());
    const auto write = [&](const QString& text, const QFont& font, const QColor& color) {
      painter->setFont(font);
      painter->setPen(selected ? bright : color);
      painter->drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                        QFontMetrics(font).elidedText(text, Qt::ElideRight, line.width()));
      line.translate(0, line.height());
    };
    painter->save();
    QFont bold = option.font;
    bold.setBold(index.data(UsefulData).toBool());
    const QColor quiet = quietColor(option.palette);
    write(index.data(TitleData).toString(), bold,
          index.data(UsefulData).toBool() ? option.palette.color(QPalette::Text) : quiet);
    write(index.data(LineData).toString(), option.font, quiet);
    if (const QString problem = index.data(ProblemData).toString(); !problem.isEmpty()) {
      write(problem, option.font, faultColor(option.palette));
    }
    painter->restore();
  }
};

} // namespace

DeviceList::DeviceList(QWidget* parent) : QListWidget(parent) {
  setItemDelegate(new DeviceDelegate(this));
  setDragEnabled(true);
  setDragDropMode(QAbstractItemView::DragOnly);
  setDefaultDropAction(Qt::CopyAction);
  setSelectionMode(QAbstractItemView::SingleSelection);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  setAccessibleName(tr("Devices that are plugged in"));
}

QSize DeviceList::sizeHint() const { return {QListWidget::sizeHint().width(), fontMetrics().lineSpacing() * 10}; }

QString DeviceList::keyAt(int row) const {
  return item(row) == nullptr ? QString() : item(row)->data(KeyData).toString();
}

void DeviceList::setDevices(const std::vector<BenchPresenter::DeviceRow>& rows, const QStringList& keys) {
  const QString selected = keyAt(currentRow());
  while (count() > static_cast<int>(rows.size())) {
    delete takeItem(count() - 1);
  }
  int current = rows.empty() ? -1 : 0;
  for (int i = 0; i < static_cast<int>(rows.size()); ++i) {
    const BenchPresenter::DeviceRow& row = rows[static_cast<std::size_t>(i)];
    if (i >= count()) {
      addItem(new QListWidgetItem);
    }
    QListWidgetItem* shown = item(i);
    const QString problem = row.problem.isEmpty() ? QString() : tr("Cannot be opened: %1").arg(row.problem);
    shown->setData(TitleData, row.title);
    shown->setData(LineData, row.use);
    shown->setData(ProblemData, problem);
    shown->setData(UsefulData, row.useful);
    shown->setData(KeyData, keys[i]);
    shown->setData(Qt::AccessibleTextRole, QStringList{row.title, row.use, problem}.join(QStringLiteral(". ")));
    shown->setToolTip(row.where);
    shown->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | (row.useful ? Qt::ItemIsDragEnabled : Qt::NoItemFlags));
    current = keys[i] == selected ? i : current;
  }
  setCurrentRow(current);
  doItemsLayout(); // rows may be higher now
}

QMimeData* DeviceList::mimeData(const QList<QListWidgetItem*>& items) const {
  if (items.isEmpty()) {
    return nullptr;
  }
  auto* dragged = new QMimeData;
  dragged->setData(mimeType(), items.first()->data(KeyData).toString().toUtf8());
  return dragged;
}

void DeviceList::askForMenu(const QPoint* globalPosition) {
  if (const QListWidgetItem* shown = currentItem()) {
    const QRect place = visualItemRect(shown);
    emit menuWanted(currentRow(),
                    globalPosition != nullptr ? *globalPosition : viewport()->mapToGlobal(place.bottomLeft()));
  }
}

void DeviceList::contextMenuEvent(QContextMenuEvent* event) {
  const bool byMouse = event->reason() == QContextMenuEvent::Mouse;
  askForMenu(byMouse ? &event->globalPos() : nullptr);
}

void DeviceList::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    askForMenu(nullptr);
    return;
  }
  QListWidget::keyPressEvent(event);
}

} // namespace straightedge::gui
