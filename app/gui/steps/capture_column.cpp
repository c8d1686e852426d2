#include "app/gui/steps/capture_column.h"

#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>

namespace straightedge::gui {

CaptureColumn::CaptureColumn(const QList<QWidget*>& boxes, const QWidget& form, Rest rest, QWidget* parent)
    : QScrollArea(parent) {
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(12);
  for (QWidget* box : boxes) {
    column->addWidget(box, rest == Rest::ToLastBox && box == boxes.last() ? 1 : 0);
  }
  if (rest == Rest::Empty) {
    column->addStretch(1);
  }
  setWidget(content);
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFixedWidth(std::max(fontMetrics().averageCharWidth() * 52,
                         form.minimumSizeHint().width() + verticalScrollBar()->sizeHint().width()));
}

} // namespace straightedge::gui
