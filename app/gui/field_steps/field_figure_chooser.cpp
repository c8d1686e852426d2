#include "app/gui/field_steps/field_figure_chooser.h"

#include "app/gui/field_steps/field_page_figures.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace straightedge::gui {

FieldFigureChooser::FieldFigureChooser(const QString& name, QWidget* parent)
    : QWidget(parent), m_box(new QComboBox(this)), m_plot(new PlotView(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* bar = new QHBoxLayout;
  auto* caption = new QLabel(tr("S&how"), this);
  caption->setBuddy(m_box);
  m_box->setObjectName(name + QStringLiteral("Figure"));
  m_box->setMaxVisibleItems(30);
  m_box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  m_plot->setObjectName(name + QStringLiteral("Plot"));
  m_plot->setMinimumHeight(180);
  bar->addWidget(caption);
  bar->addWidget(m_box);
  bar->addStretch(1);
  layout->addLayout(bar);
  layout->addWidget(m_plot, 1);
  connect(m_box, &QComboBox::currentIndexChanged, this, [this](int place) {
    if (place >= 0 && place < m_figures.size()) {
      m_chosen = m_figures[place].stem;
    }
    showChosen();
  });
}

void FieldFigureChooser::setFigures(const QList<NamedFigure>& figures, const PlotSpec& otherwise) {
  m_figures = figures;
  m_otherwise = otherwise;
  const QSignalBlocker quiet(m_box);
  m_box->clear();
  for (const NamedFigure& figure : m_figures) {
    m_box->addItem(shortName(figure));
    m_box->setItemData(m_box->count() - 1, figure.caption, Qt::ToolTipRole);
  }
  m_box->setEnabled(!m_figures.isEmpty());
  m_box->setCurrentIndex(placeOf(m_figures, m_chosen)); // the choice comes back with its figure
  showChosen();
}

void FieldFigureChooser::chooseFigure(const QString& stem) {
  m_chosen = stem;
  const QSignalBlocker quiet(m_box);
  m_box->setCurrentIndex(placeOf(m_figures, m_chosen));
  showChosen();
}

void FieldFigureChooser::showChosen() {
  const int place = m_box->currentIndex();
  m_plot->setSpec(place >= 0 && place < m_figures.size() ? m_figures[place].make() : m_otherwise);
}

} // namespace straightedge::gui
