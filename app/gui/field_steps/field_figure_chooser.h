// A plot or a three-dimensional picture with a box to choose it from; keeps the choice by the figure's name while
// results come and go.
#pragma once

#include "app/gui/figures/named_figure.h"
#include "app/gui/plots/plot_view.h"

#include <QList>
#include <QWidget>

class QComboBox;
class QStackedWidget;

namespace straightedge::gui {

class SceneView;

/// GUI thread.
class FieldFigureChooser : public QWidget {
  Q_OBJECT
public:
  /// `name` begins the names of box and plot: "fit" makes "fitFigure" and "fitPlot".
  FieldFigureChooser(const QString& name, QWidget* parent = nullptr);

  /// `otherwise` is shown where there is no figure.
  void setFigures(const QList<NamedFigure>& figures, const PlotSpec& otherwise);
  void chooseFigure(const QString& stem); ///< once it is there
  PlotView& plot() { return *m_plot; }
  SceneView* scene() { return m_scene; } ///< null until a three-dimensional figure was chosen

private:
  void showChosen();

  QString m_name;
  QList<NamedFigure> m_figures;
  PlotSpec m_otherwise;
  QString m_chosen;
  QComboBox* m_box;
  QStackedWidget* m_stack;
  PlotView* m_plot;
  SceneView* m_scene = nullptr;
};

} // namespace straightedge::gui
