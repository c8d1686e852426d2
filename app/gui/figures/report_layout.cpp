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
  const auto turnTo = [&](int next) {
    pages.append(page);
    page.clear();
    y = 0.0;
    if (const int header = boxes[next].repeats; header >= 0) {
      page.append({y, header});
      y += boxes[header].height;
    }
  };
  for (int first = 0; first < boxes.size();) {
    int last = first; // the group that must not be torn apart
    double needed = boxes[first].height;
    while (boxes[last].keepWithNext && last + 1 < boxes.size()) {
      ++last;
      needed += boxes[last].spaceBefore + boxes[last].height;
    }
    if (!page.isEmpty() && y + boxes[first].spaceBefore + needed > height) {
      turnTo(first);
    }
    for (int i = first; i <= last; ++i) {
      if (!page.isEmpty() && i > first && y + boxes[i].spaceBefore + boxes[i].height > height) {
        turnTo(i); // a group taller than a page is torn after all
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
