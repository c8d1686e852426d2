#include "app/gui/shell/table_clipboard.h"

#include "app/gui/plots/plot_view.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QMap>
#include <QMetaMethod>

#include <set>

namespace straightedge::gui {

namespace {

QString cellText(const QModelIndex& index) {
  QString text = index.data(Qt::DisplayRole).toString();
  return text.replace('\t', ' ').replace('\n', ' ');
}

QString tableText(const QAbstractItemView& view) {
  const auto& model = *view.model();
  std::set<int> rows;
  std::set<int> columns;
  const auto selected = view.selectionModel() != nullptr ? view.selectionModel()->selectedIndexes() : QModelIndexList();
  for (const QModelIndex& index : selected) {
    rows.insert(index.row());
    columns.insert(index.column());
  }
  if (selected.isEmpty()) {
    for (int row = 0; row < model.rowCount(view.rootIndex()); ++row) {
      rows.insert(row);
    }
    for (int column = 0; column < model.columnCount(view.rootIndex()); ++column) {
      columns.insert(column);
    }
  }
  QStringList lines;
  QStringList titles;
  for (const int column : columns) {
    titles << model.headerData(column, Qt::Horizontal).toString();
  }
  if (columns.size() > 1 || selected.isEmpty()) {
    lines << titles.join('\t');
  }
  for (const int row : rows) {
    QStringList cells;
    for (const int column : columns) {
      cells << cellText(model.index(row, column, view.rootIndex()));
    }
    lines << cells.join('\t');
  }
  return lines.join('\n');
}

} // namespace

bool copyFrom(QWidget* widget) {
  if (widget == nullptr) {
    return false;
  }
  if (const auto* plot = qobject_cast<PlotView*>(widget)) {
    QApplication::clipboard()->setImage(plot->picture(plot->size(), 2.0));
    return true;
  }
  if (widget->metaObject()->indexOfMethod("copy()") >= 0) {
    return QMetaObject::invokeMethod(widget, "copy");
  }
  if (const auto* view = qobject_cast<QAbstractItemView*>(widget); view != nullptr && view->model() != nullptr) {
    QApplication::clipboard()->setText(tableText(*view));
    return true;
  }
  if (const auto* label = qobject_cast<QLabel*>(widget); label != nullptr && label->hasSelectedText()) {
    QApplication::clipboard()->setText(label->selectedText());
    return true;
  }
  return false;
}

} // namespace straightedge::gui
