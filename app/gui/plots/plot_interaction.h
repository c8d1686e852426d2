// Mouse, wheel and keys on a PlotView.
#pragma once

#include "app/gui/plots/plot_view.h"
#include "app/gui/plots/plot_window.h"

#include <QPointF>
#include <QRectF>

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace straightedge::gui {

/// A press becomes a click or, once the pointer has moved by the desktop's drag distance, a drag; never both.
class PlotInteraction {
public:
  PlotInteraction(PlotView& view, PlotView::Impl& impl) : m_view(view), m_impl(impl) {}

  void press(const QMouseEvent& event);
  void move(const QMouseEvent& event);
  void release(const QMouseEvent& event);
  void doubleClick(const QMouseEvent& event);
  void wheel(const QWheelEvent& event);
  bool key(const QKeyEvent& event);
  void leave();
  void showMenu(const QPoint& globalPosition);

  QRectF rubberBand() const; ///< empty when there is none
  int hoveredGuide() const { return m_hoveredGuide; }
  QPointF pointer() const { return m_pointer; }
  bool pointerInside() const { return m_inside; }

private:
  enum class Drag : std::uint8_t { None, Undecided, Pan, ZoomBand, SelectBand, Guide };

  void zoomAt(const QPointF& position, double factorX, double factorY);
  void pan(const QPointF& to);
  void finishBand();
  void cancelDrag();
  void stepPoint(int direction);
  void stepSeries(int direction);
  void updateCursor(const QPointF& position);
  int legendAt(const QPointF& position) const;

  PlotView& m_view;
  PlotView::Impl& m_impl;
  Drag m_drag = Drag::None;
  Drag m_intended = Drag::None;
  Qt::MouseButton m_button = Qt::NoButton;
  QPointF m_pressedAt, m_pointer;
  PlotWindow m_windowAtPress;
  int m_hoveredGuide = -1;
  bool m_inside = false;
};

} // namespace straightedge::gui
