#include "app/gui/steps/result_table.h"

#include "app/gui/figures/report_tables.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMenu>

#include <algorithm>

namespace straightedge::gui {

ResultTable::ResultTable(QWidget* parent) : QTableWidget(parent) {
  setEditTriggers(NoEditTriggers);
  setSelectionBehavior(SelectRows);
  setSelectionMode(ExtendedSelection);
  setAlternatingRowColors(true);
  setShowGrid(false);
  setWordWrap(false);
  setCornerButtonEnabled(false);
  verticalHeader()->setVisible(false);
  verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 10);
  horizontalHeader()->setHighlightSections(false);
  horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  setHorizontalScrollMode(ScrollPerPixel);
}

void ResultTable::setTable(const ReportTable& table) {
  const int row = table.rows.size() == m_table.rows.size() ? currentRow() : -1;
  m_table = table;
  setColumnCount(static_cast<int>(table.header.size()));
  setRowCount(static_cast<int>(table.rows.size()));
  for (int c = 0; c < columnCount(); ++c) {
    auto* header = new QTableWidgetItem(table.header[c]);
    const bool numeric = c >= table.firstNumericColumn && c <= table.lastNumericColumn;
    header->setTextAlignment((numeric ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    setHorizontalHeaderItem(c, header);
  }
  for (int r = 0; r < rowCount(); ++r) {
    for (int c = 0; c < columnCount(); ++c) {
      auto* cell = new QTableWidgetItem(c < table.rows[r].size() ? table.rows[r][c] : QString());
      const bool numeric = c >= table.firstNumericColumn && c <= table.lastNumericColumn;
      cell->setTextAlignment((numeric ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
      setItem(r, c, cell);
    }
  }
  if (row >= 0) {
    setCurrentCell(row, 0);
  }
}

QString ResultTable::selectedText() const {
  ReportTable part = m_table;
  part.rows.clear();
  for (int r = 0; r < rowCount(); ++r) {
    if (selectionModel()->isRowSelected(r)) {
      part.rows.append(m_table.rows[r]);
    }
  }
  return tableAsText(part.rows.isEmpty() ? m_table : part);
}

void ResultTable::copy() { QGuiApplication::clipboard()->setText(selectedText()); }

void ResultTable::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Copy)) {
    copy();
    event->accept();
    return;
  }
  QTableWidget::keyPressEvent(event);
}

void ResultTable::contextMenuEvent(QContextMenuEvent* event) {
  QMenu menu(this);
  menu.addAction(selectedItems().isEmpty() ? tr("Copy table") : tr("Copy selected rows"), this, &ResultTable::copy);
  if (!selectedItems().isEmpty()) {
    menu.addAction(tr("Copy whole table"), this,
                   [this] { QGuiApplication::clipboard()->setText(tableAsText(m_table)); });
  }
  menu.exec(event->globalPos());
}

} // namespace straightedge::gui
