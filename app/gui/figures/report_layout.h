// Breaks a report into pages: measured boxes that are never cut, tables that go on with their header repeated,
// headings that stay with what follows. Units: logical pixels of 1/96 inch.
#pragma once

#include "app/gui/figures/report_content.h"

#include <QList>
#include <QRectF>

#include <functional>

class QPainter;

namespace straightedge::gui {

/// Something measured that can be drawn with its upper left corner at a point.
struct ReportBox {
  double height = 0.0;
  double spaceBefore = 0.0; ///< left out at the top of a page
  bool keepWithNext = false;
  int repeats = -1; ///< a table's header, drawn again where this box begins a page; −1: none
  std::function<void(QPainter&, QPointF)> draw;
};

struct PlacedBox {
  double y = 0.0;
  int box = 0; ///< index into the boxes
};

/// Boxes of one report in reading order; `width` is the text width.
QList<ReportBox> reportBoxes(const ReportContent& content, double width);

/// Pages of boxes; `height` is the usable height of a page. A box that is kept with the next moves with it. Every box
/// occurs once, headers of tables once more on every page that their table goes on to.
QList<QList<PlacedBox>> paginate(const QList<ReportBox>& boxes, double height);

} // namespace straightedge::gui
