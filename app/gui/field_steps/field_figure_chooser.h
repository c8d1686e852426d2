// A plot with a box to choose its figure from; keeps the choice by the figure's name while results come and go.
#pragma once

#include "app/gui/figures/named_figure.h"
#include "app/gui/plots/plot_view.h"

#include <QList>
#include <QWidget>

class QComboBox;

namespace straightedge::gui {

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

private:
  void showChosen();

  QList<NamedFigure> m_figures;
  PlotSpec m_otherwise;
  QString m_chosen;
  QComboBox* m_box;
  PlotView* m_plot;
};

} // namespace straightedge::gui
