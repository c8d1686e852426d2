#include "app/gui/field_steps/field_figure_chooser.h"

#include "app/gui/field_steps/field_page_figures.h"
#include "app/gui/plots/scene_view.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QVBoxLayout>

namespace straightedge::gui {

FieldFigureChooser::FieldFigureChooser(const QString& name, QWidget* parent)
    : QWidget(parent), m_name(name), m_box(new QComboBox(this)), m_stack(new QStackedWidget(this)),
      m_plot(new PlotView(m_stack)) {
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
  m_stack->addWidget(m_plot);
  layout->addWidget(m_stack, 1);
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
  if (place < 0 || place >= m_figures.size()) {
    m_plot->setSpec(m_otherwise);
    m_stack->setCurrentWidget(m_plot);
  } else if (!m_figures[place].isScene()) {
    m_plot->setSpec(m_figures[place].make());
    m_stack->setCurrentWidget(m_plot);
  } else {
    if (m_scene == nullptr) {
      m_scene = new SceneView(m_stack);
      m_scene->setObjectName(m_name + QStringLiteral("Scene"));
      m_scene->setMinimumHeight(180);
      m_scene->setToolTip(tr("Drag or arrow keys turn it, the wheel or + and − zoom, double click or Home resets"));
      m_stack->addWidget(m_scene);
    }
    m_scene->setSpec(m_figures[place].scene());
    m_stack->setCurrentWidget(m_scene);
  }
}

} // namespace straightedge::gui
