// Inside of PlotView, shared by its painting and its interaction.
#pragma once

#include "app/gui/plots/chart_scene.h"
#include "app/gui/plots/picking.h"
#include "app/gui/plots/plot_interaction.h"
#include "app/gui/plots/plot_layout.h"
#include "app/gui/plots/plot_view.h"
#include "app/gui/plots/plot_window.h"

#include <QHash>
#include <QImage>

#include <optional>

namespace straightedge::gui {

struct PlotView::Impl {
  explicit Impl(PlotView& owner) : view(owner), interaction(owner, *this) {}

  PlotView& view;
  PlotSpec spec;
  std::optional<PlotTheme> chosenTheme;
  QHash<QString, bool> switched; ///< by the user, by name of the series
  std::optional<PlotWindow> zoom;
  bool magnifier = false;
  QString draggedGuide; ///< while it is dragged its value is the pointer's, whatever setSpec brings

  PickedPoint marked; ///< the point with hover text
  PlotInteraction interaction;

  /// Whole range and layout are found again only after a change; the picture only when it shows something else.
  void dataChanged();
  void windowChanged();
  void repaintAll();
  const PlotWindow& whole();
  const PlotWindow& window();
  const PlotLayout& layout();
  const QImage& picture(double devicePixelRatio);
  void paintOverlay(QPainter& painter);
  void setZoom(const std::optional<PlotWindow>& wanted);
  void mark(const PickedPoint& point);
  void describeForAccessibility();

private:
  ChartScene m_scene;
  std::optional<PlotWindow> m_whole;
  std::optional<PlotLayout> m_layout;
  QSize m_layoutSize;
  QImage m_picture;
  bool m_pictureValid = false;
};

} // namespace straightedge::gui
