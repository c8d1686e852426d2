#include "app/gui/plots/plot_interaction.h"

#include "app/gui/plots/guides.h"
#include "app/gui/plots/plot_view_impl.h"

#include <QGuiApplication>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QStyleHints>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace straightedge::gui {
namespace {

constexpr double wheelStep = 1.2; ///< per notch
constexpr double keyStep = 1.25;
constexpr double thinBand = 8.0; ///< a rectangle thinner than this zooms only along its length

} // namespace

QRectF PlotInteraction::rubberBand() const {
  if (m_drag != Drag::ZoomBand && m_drag != Drag::SelectBand) {
    return {};
  }
  QRectF band = QRectF(m_pressedAt, m_pointer).normalized();
  band.setSize(band.size().expandedTo({1.0, 1.0})); // a perfectly straight drag is no empty rectangle
  return band.intersected(m_impl.layout().plot);
}

int PlotInteraction::legendAt(const QPointF& position) const {
  for (const LegendEntry& entry : m_impl.layout().legend) {
    if (entry.series >= 0 && entry.rect.contains(position)) {
      return entry.series;
    }
  }
  return -1;
}

void PlotInteraction::press(const QMouseEvent& event) {
  if (m_drag != Drag::None && m_drag != Drag::Undecided) {
    return; // a second button during a drag
  }
  m_pressedAt = m_pointer = event.position();
  m_button = event.button();
  m_windowAtPress = m_impl.window();
  m_drag = Drag::Undecided;
  m_intended = Drag::None;
  const PlotLayout& layout = m_impl.layout();
  if (m_impl.spec.polar || legendAt(m_pressedAt) >= 0) {
    return;
  }
  if (m_button == Qt::LeftButton) {
    const int guide = guideAt(m_impl.spec, m_impl.window(), layout, m_pressedAt);
    if (guide >= 0) {
      m_intended = Drag::Guide;
      m_impl.draggedGuide = m_impl.spec.guides[guide].id;
    } else if (event.modifiers().testFlag(Qt::ControlModifier)) {
      m_intended = Drag::SelectBand;
    } else if (event.modifiers().testFlag(Qt::ShiftModifier)) {
      m_intended = Drag::ZoomBand;
    } else {
      m_intended = Drag::Pan;
    }
  } else if (m_button == Qt::RightButton) {
    m_intended = Drag::ZoomBand;
  } else if (m_button == Qt::MiddleButton) {
    m_intended = Drag::Pan;
  }
}

void PlotInteraction::move(const QMouseEvent& event) {
  m_pointer = event.position();
  m_inside = true;
  if (m_drag == Drag::Undecided) {
    const double moved = (m_pointer - m_pressedAt).manhattanLength();
    if (m_intended != Drag::None && moved >= QGuiApplication::styleHints()->startDragDistance()) {
      m_drag = m_intended;
      m_impl.mark({});
    }
  }
  switch (m_drag) {
  case Drag::None:
    m_impl.mark(nearestPoint(m_impl.spec, m_impl.window(), m_impl.layout(), m_pointer));
    updateCursor(m_pointer);
    if (m_impl.magnifier) {
      m_view.update();
    }
    break;
  case Drag::Undecided:
    break;
  case Drag::Pan:
    pan(m_pointer);
    break;
  case Drag::ZoomBand:
  case Drag::SelectBand:
    m_view.update();
    break;
  case Drag::Guide:
    for (qsizetype i = 0; i < m_impl.spec.guides.size(); ++i) {
      PlotGuide& guide = m_impl.spec.guides[i];
      if (guide.id == m_impl.draggedGuide) {
        const QString id = guide.id; // a receiver may bring a new spec: `guide` ends then
        const double value = draggedValue(guide, m_impl.window(), m_impl.layout(), m_pointer);
        guide.value = value;
        m_view.update();
        emit m_view.guideDragged(id, value);
        break;
      }
    }
    break;
  }
}

void PlotInteraction::release(const QMouseEvent& event) {
  m_pointer = event.position();
  if (event.button() != m_button) {
    return;
  }
  const Drag ended = m_drag;
  m_button = Qt::NoButton;
  switch (ended) {
  case Drag::Undecided: {
    m_drag = Drag::None;
    m_impl.draggedGuide.clear();
    const int legend = legendAt(m_pressedAt);
    if (event.button() == Qt::RightButton) {
      showMenu(event.globalPosition().toPoint());
    } else if (event.button() == Qt::LeftButton && legend >= 0) {
      m_view.setSeriesVisible(legend, !m_impl.spec.series[legend].visible);
    } else if (event.button() == Qt::LeftButton && m_intended != Drag::Guide) {
      const PickedPoint point = nearestPoint(m_impl.spec, m_impl.window(), m_impl.layout(), m_pressedAt);
      if (point) {
        emit m_view.pointClicked(point.series, point.index);
      }
    }
    break;
  }
  case Drag::ZoomBand:
  case Drag::SelectBand:
    finishBand();
    m_drag = Drag::None;
    m_view.update();
    break;
  case Drag::Guide: {
    m_drag = Drag::None;
    const QString id = m_impl.draggedGuide;
    m_impl.draggedGuide.clear();
    for (const PlotGuide& guide : std::as_const(m_impl.spec.guides)) {
      if (guide.id == id) {
        emit m_view.guideDropped(id, guide.value);
        break;
      }
    }
    break;
  }
  case Drag::None:
  case Drag::Pan:
    m_drag = Drag::None;
    break;
  }
  updateCursor(m_pointer);
}

void PlotInteraction::doubleClick(const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton) {
    return;
  }
  if (legendAt(event.position()) >= 0) { // two quick clicks on the legend are two clicks
    press(event);
    return;
  }
  m_drag = Drag::None;
  m_button = Qt::NoButton;
  m_view.resetZoom();
}

void PlotInteraction::wheel(const QWheelEvent& event) {
  if (m_impl.spec.polar) {
    return;
  }
  const double notches = event.angleDelta().y() / 120.0;
  const double factor = std::pow(wheelStep, -notches);
  const QRectF& plot = m_impl.layout().plot;
  const QPointF at = event.position();
  const bool belowPlot = at.y() > plot.bottom();
  const bool besidePlot = at.x() < plot.left() || at.x() > plot.right();
  if (belowPlot && besidePlot) {
    return;
  }
  zoomAt(at, besidePlot ? 1.0 : factor, belowPlot ? 1.0 : factor);
}

void PlotInteraction::zoomAt(const QPointF& position, double factorX, double factorY) {
  const QRectF& plot = m_impl.layout().plot;
  const double u = std::clamp((position.x() - plot.left()) / plot.width(), 0.0, 1.0);
  const double v = std::clamp((plot.bottom() - position.y()) / plot.height(), 0.0, 1.0);
  m_impl.setZoom(
      m_impl.window().part(u - u * factorX, v - v * factorY, u + (1.0 - u) * factorX, v + (1.0 - v) * factorY));
}

void PlotInteraction::pan(const QPointF& to) {
  const QRectF& plot = m_impl.layout().plot;
  const double u = (m_pressedAt.x() - to.x()) / plot.width();
  const double v = (to.y() - m_pressedAt.y()) / plot.height();
  m_view.setCursor(Qt::ClosedHandCursor);
  m_impl.setZoom(m_windowAtPress.part(u, v, 1.0 + u, 1.0 + v));
}

void PlotInteraction::finishBand() {
  const QRectF band = rubberBand();
  const QRectF plot = m_impl.layout().plot;
  if (m_drag == Drag::SelectBand) {
    for (int series = 0; series < m_impl.spec.series.size(); ++series) {
      const QList<int> found = pointsWithin(m_impl.spec, series, m_impl.window(), m_impl.layout(), band);
      if (!found.isEmpty()) {
        emit m_view.pointsSelected(series, found);
      }
    }
    return;
  }
  const bool wide = band.width() >= thinBand;
  const bool high = band.height() >= thinBand;
  if (!wide && !high) {
    return;
  }
  const double left = wide ? (band.left() - plot.left()) / plot.width() : 0.0;
  const double right = wide ? (band.right() - plot.left()) / plot.width() : 1.0;
  const double bottom = high ? (plot.bottom() - band.bottom()) / plot.height() : 0.0;
  const double top = high ? (plot.bottom() - band.top()) / plot.height() : 1.0;
  m_impl.setZoom(m_impl.window().part(left, bottom, right, top));
}

void PlotInteraction::cancelDrag() {
  if (m_drag == Drag::Pan) {
    m_impl.setZoom(m_windowAtPress);
  }
  m_drag = Drag::None;
  m_impl.draggedGuide.clear();
  m_view.update();
}

bool PlotInteraction::key(const QKeyEvent& event) {
  const QPointF middle = m_impl.layout().plot.center();
  switch (event.key()) {
  case Qt::Key_Left:
    stepPoint(-1);
    return true;
  case Qt::Key_Right:
    stepPoint(1);
    return true;
  case Qt::Key_Up:
    stepSeries(-1);
    return true;
  case Qt::Key_Down:
    stepSeries(1);
    return true;
  case Qt::Key_Plus:
  case Qt::Key_Equal:
    zoomAt(middle, 1.0 / keyStep, 1.0 / keyStep);
    return true;
  case Qt::Key_Minus:
    zoomAt(middle, keyStep, keyStep);
    return true;
  case Qt::Key_Home:
    m_view.resetZoom();
    return true;
  case Qt::Key_Return:
  case Qt::Key_Enter:
    if (m_impl.marked) {
      emit m_view.pointClicked(m_impl.marked.series, m_impl.marked.index);
      return true;
    }
    return false;
  case Qt::Key_Escape:
    if (m_drag == Drag::None && !m_impl.marked) {
      return false; // a dialog may want it
    }
    cancelDrag();
    m_impl.mark({});
    return true;
  default:
    break;
  }
  const int digit = event.key() - Qt::Key_1;
  if (digit >= 0 && digit < 9 && !(event.modifiers() & (Qt::ControlModifier | Qt::AltModifier))) {
    int entry = 0;
    for (int series = 0; series < m_impl.spec.series.size(); ++series) {
      if (!m_impl.spec.series[series].name.isEmpty() && entry++ == digit) {
        m_view.setSeriesVisible(series, !m_impl.spec.series[series].visible);
        return true;
      }
    }
  }
  return false;
}

void PlotInteraction::stepPoint(int direction) {
  if (m_impl.marked) {
    m_impl.mark(neighbour(m_impl.spec, m_impl.window(), m_impl.layout(), m_impl.marked, direction));
    return;
  }
  for (int series = 0; series < m_impl.spec.series.size(); ++series) {
    if (m_impl.spec.series[series].visible) { // the first point that can be seen, or the last
      const auto count = static_cast<int>(m_impl.spec.series[series].x.size());
      const PickedPoint before{series, direction > 0 ? -1 : count, {}};
      const PickedPoint first = neighbour(m_impl.spec, m_impl.window(), m_impl.layout(), before, direction);
      if (first.index >= 0 && first.index < count) {
        m_impl.mark(first);
        return;
      }
    }
  }
}

void PlotInteraction::stepSeries(int direction) {
  if (!m_impl.marked) {
    stepPoint(1);
    return;
  }
  const auto count = static_cast<int>(m_impl.spec.series.size());
  for (int k = 1; k < count; ++k) {
    const int series = (m_impl.marked.series + direction * k + count * k) % count;
    if (!m_impl.spec.series[series].visible) {
      continue;
    }
    PlotSpec alone = m_impl.spec; // shares the data
    for (int i = 0; i < count; ++i) {
      alone.series[i].visible = i == series;
    }
    const PickedPoint point =
        nearestPoint(alone, m_impl.window(), m_impl.layout(), m_impl.marked.pixels, m_view.width() + m_view.height());
    if (point) {
      m_impl.mark(point);
      return;
    }
  }
}

void PlotInteraction::leave() {
  m_inside = false;
  m_hoveredGuide = -1;
  m_impl.mark({});
  m_view.update();
}

void PlotInteraction::updateCursor(const QPointF& position) {
  const int guide = m_impl.spec.polar ? -1 : guideAt(m_impl.spec, m_impl.window(), m_impl.layout(), position);
  if (guide != m_hoveredGuide) {
    m_hoveredGuide = guide;
    m_view.update();
  }
  if (guide >= 0) {
    m_view.setCursor(m_impl.spec.guides[guide].vertical ? Qt::SizeHorCursor : Qt::SizeVerCursor);
  } else if (legendAt(position) >= 0) {
    m_view.setCursor(Qt::PointingHandCursor);
  } else if (!m_impl.spec.polar && m_impl.layout().plot.contains(position)) {
    m_view.setCursor(Qt::CrossCursor);
  } else {
    m_view.unsetCursor();
  }
}

void PlotInteraction::showMenu(const QPoint& globalPosition) {
  QMenu* menu = m_view.makeContextMenu(&m_view);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->popup(globalPosition);
}

} // namespace straightedge::gui
