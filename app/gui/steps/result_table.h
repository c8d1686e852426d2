// A table of results: numbers to the right, rows that can be picked, Ctrl+C and a menu that copy it for a spreadsheet.
#pragma once

#include "app/gui/figures/report_content.h"

#include <QTableWidget>

namespace straightedge::gui {

class ResultTable : public QTableWidget {
  Q_OBJECT
public:
  explicit ResultTable(QWidget* parent = nullptr);

  /// Keeps the current row where the new table has as many.
  void setTable(const ReportTable& table);
  QString selectedText() const; ///< tab-separated, with the header; the whole table where nothing is selected
  void copy();

protected:
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

private:
  ReportTable m_table;
};

} // namespace straightedge::gui
