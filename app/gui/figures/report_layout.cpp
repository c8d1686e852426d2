#include "app/gui/figures/report_layout.h"

#include "app/gui/figures/report_boxes.h"

namespace straightedge::gui {

QList<ReportBox> reportBoxes(const ReportContent& content, double width) {
  QList<ReportBox> boxes;
  addTitle(boxes, content, width);
  for (const ReportBlock& block : content.blocks) {
    std::visit([&boxes, width](const auto& each) { addBoxes(boxes, each, width); }, block);
  }
  return boxes;
}

QList<QList<PlacedBox>> paginate(const QList<ReportBox>& boxes, double height) {
  QList<QList<PlacedBox>> pages;
  QList<PlacedBox> page;
  double y = 0.0;
  for (int first = 0; first < boxes.size();) {
    int last = first; // the group that must not be torn apart
    double needed = boxes[first].height;
    while (boxes[last].keepWithNext && last + 1 < boxes.size()) {
      ++last;
      needed += boxes[last].spaceBefore + boxes[last].height;
    }
    if (!page.isEmpty() && y + boxes[first].spaceBefore + needed > height) {
      pages.append(page);
      page.clear();
      y = 0.0;
    }
    for (int i = first; i <= last; ++i) {
      if (!page.isEmpty() && i > first && y + boxes[i].spaceBefore + boxes[i].height > height) {
        pages.append(page); // a group taller than a page is torn after all
        page.clear();
        y = 0.0;
      }
      y += page.isEmpty() ? 0.0 : boxes[i].spaceBefore;
      page.append({y, i});
      y += boxes[i].height;
    }
    first = last + 1;
  }
  if (!page.isEmpty()) {
    pages.append(page);
  }
  return pages;
}

} // namespace straightedge::gui
