#include "app/gui/steps/model_list.h"

#include "app/gui/figures/figure_parts.h"
#include "app/gui/plots/theme.h"
#include "app/gui/steps/fit_presenter.h"
#include "app/gui/steps/step_page.h"

#include <QEvent>
#include <QPainter>
#include <QScopedValueRollback>

namespace straightedge::gui {

namespace {

QIcon swatch(const QWidget& widget, SeriesColor role) {
  constexpr int side = 12;
  const double ratio = widget.devicePixelRatioF();
  QPixmap picture(QSize(side, side) * ratio);
  picture.setDevicePixelRatio(ratio);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(PlotColors::series(role, plotThemeOf(widget)));
  painter.drawRoundedRect(QRectF(1.0, 1.0, side - 2.0, side - 2.0), 2.5, 2.5);
  return QIcon(picture);
}

} // namespace

ModelList::ModelList(FitPresenter& presenter, QWidget* parent) : ResultTable(parent), m_presenter(presenter) {
  setObjectName(QStringLiteral("models"));
  setSelectionMode(SingleSelection);
  connect(this, &QTableWidget::itemChanged, this, [this](QTableWidgetItem* item) {
    if (!m_filling && item->column() == 0) {
      m_presenter.setShown(item->row(), item->checkState() == Qt::Checked);
    }
  });
  connect(this, &QTableWidget::cellDoubleClicked, this, [this](int row) { m_presenter.selectModel(row); });
}

void ModelList::refresh() {
  const QScopedValueRollback filling(m_filling, true);
  setTable(m_presenter.modelsTable());
  for (int row = 0; row < rowCount(); ++row) {
    QTableWidgetItem* cell = item(row, 0);
    cell->setFlags(cell->flags() | Qt::ItemIsUserCheckable);
    cell->setCheckState(m_presenter.isShown(row) ? Qt::Checked : Qt::Unchecked);
    cell->setIcon(swatch(*this, seriesColor(row)));
    const bool selected = row == m_presenter.selectedModel();
    cell->setToolTip(selected ? tr("Verify uses this model") : tr("Double click: Verify uses this model"));
    QFont bold = font();
    bold.setBold(selected);
    cell->setFont(bold);
  }
}

void ModelList::changeEvent(QEvent* event) {
  ResultTable::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && rowCount() > 0) {
    refresh();
  }
}

} // namespace straightedge::gui
