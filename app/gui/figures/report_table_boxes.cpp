// Tables of the report: columns as wide as their contents where that fits, one box per row so that a table may go on on
// the next page.
#include "app/gui/figures/report_boxes.h"

#include <QFont>
#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <numeric>

namespace straightedge::gui {

namespace {

constexpr int cellPixels = 12;
constexpr double columnGap = 18.0;
constexpr double rowPadding = 3.5;
/// Rows kept together at the start and the end of a table, so that none stands alone on a page.
constexpr qsizetype rowsKept = 2;

QList<double> columnWidths(const ReportTable& table, double width) {
  const QFontMetricsF plain(reportFont(cellPixels));
  const QFontMetricsF bold(reportFont(cellPixels, true));
  qsizetype columns = table.header.size();
  for (const QStringList& row : table.rows) {
    columns = std::max(columns, row.size());
  }
  QList<double> widths(columns, 0.0);
  for (int c = 0; c < table.header.size(); ++c) {
    widths[c] = bold.horizontalAdvance(table.header[c]) + 1.0;
  }
  for (const QStringList& row : table.rows) {
    for (int c = 0; c < row.size(); ++c) {
      widths[c] = std::max(widths[c], plain.horizontalAdvance(row[c]) + 1.0);
    }
  }
  const double room = width - columnGap * static_cast<double>(std::max<qsizetype>(columns - 1, 0));
  const double natural = std::accumulate(widths.begin(), widths.end(), 0.0);
  if (natural > room && !widths.isEmpty()) {
    // only the widest column gives way: it holds sentences, the others hold numbers and names
    double& widest = *std::ranges::max_element(widths);
    widest = std::max(60.0, widest - (natural - room));
  }
  return widths;
}

ReportBox rowBox(const ReportTable& table, const QStringList& cells, const QList<double>& widths, bool header) {
  struct Cell {
    ReportBox text;
    double x;
  };
  QList<Cell> placed;
  double x = 0.0;
  double height = 0.0;
  const QFont font = reportFont(cellPixels, header);
  const QFontMetricsF metrics(font);
  for (int c = 0; c < cells.size(); ++c) {
    const bool numeric = c >= table.firstNumericColumn && c <= table.lastNumericColumn;
    const bool label = table.header.isEmpty() && c == 0;
    const ReportBox text = textBox(cells[c], font, label ? reportQuietInk : reportInk, widths[c]);
    const double slack = numeric ? std::max(0.0, widths[c] - metrics.horizontalAdvance(cells[c])) : 0.0;
    placed.append({text, x + slack});
    height = std::max(height, text.height);
    x += widths[c] + columnGap;
  }
  const double ruleWidth = std::max(0.0, x - columnGap);
  ReportBox box;
  box.height = height + 2.0 * rowPadding;
  box.draw = [placed, ruleWidth, header, rowHeight = box.height](QPainter& painter, QPointF at) {
    for (const Cell& cell : placed) {
      cell.text.draw(painter, at + QPointF(cell.x, rowPadding));
    }
    painter.setPen(header ? QPen(reportInk, 1.2) : QPen(QColor(0xe3, 0xe6, 0xec), 0.8));
    painter.drawLine(at + QPointF(0.0, rowHeight), at + QPointF(ruleWidth, rowHeight));
  };
  return box;
}

} // namespace

void addBoxes(QList<ReportBox>& boxes, const ReportTable& table, double width) {
  const QList<double> widths = columnWidths(table, width);
  double spaceBefore = 14.0;
  if (!table.caption.isEmpty()) {
    ReportBox caption = textBox(table.caption, reportFont(cellPixels), reportQuietInk, width);
    caption.spaceBefore = spaceBefore;
    caption.keepWithNext = true;
    boxes.append(caption);
    spaceBefore = 2.0;
  }
  int headerBox = -1;
  if (!table.header.isEmpty()) {
    ReportBox header = rowBox(table, table.header, widths, true);
    header.spaceBefore = spaceBefore;
    header.keepWithNext = true;
    headerBox = static_cast<int>(boxes.size());
    boxes.append(header);
    spaceBefore = 0.0;
  }
  for (qsizetype r = 0; r < table.rows.size(); ++r) {
    ReportBox row = rowBox(table, table.rows[r], widths, false);
    row.spaceBefore = r == 0 ? spaceBefore : 0.0;
    row.repeats = headerBox;
    row.keepWithNext = r + 1 < table.rows.size() && (r + 1 < rowsKept || r + rowsKept >= table.rows.size());
    boxes.append(row);
  }
}

} // namespace straightedge::gui
