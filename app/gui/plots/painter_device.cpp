#include "app/gui/plots/painter_device.h"

#include <QPaintEngine>
#include <QPainter>
#include <QPainterPath>
#include <QPolygonF>
#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkContextScene.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkRect.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace straightedge::gui {
namespace {

/// QPainter's raster engine takes time with the square of a wide polyline's length: it fills the outline of the whole.
/// From this many points on a run is drawn in short pieces …
constexpr qsizetype pieceLength = 32;
/// … and where there are more points than this per device pixel, in several shifted lines of one pixel, which are
/// quick.
constexpr double densePoints = 1.3;

QPainterPath markerPath(int shape, double r) {
  QPainterPath path;
  switch (shape) {
  case VTK_MARKER_CROSS:
    path.moveTo(-r, -r);
    path.lineTo(r, r);
    path.moveTo(-r, r);
    path.lineTo(r, -r);
    break;
  case VTK_MARKER_PLUS:
    path.moveTo(-r, 0);
    path.lineTo(r, 0);
    path.moveTo(0, -r);
    path.lineTo(0, r);
    break;
  case VTK_MARKER_SQUARE:
    path.addRect(QRectF(-0.9 * r, -0.9 * r, 1.8 * r, 1.8 * r));
    break;
  case VTK_MARKER_DIAMOND:
    path.addPolygon(QPolygonF({{0, -1.25 * r}, {1.25 * r, 0}, {0, 1.25 * r}, {-1.25 * r, 0}, {0, -1.25 * r}}));
    break;
  case PainterDevice::triangleMarker:
    path.addPolygon(QPolygonF({{0, -1.2 * r}, {1.15 * r, 0.9 * r}, {-1.15 * r, 0.9 * r}, {0, -1.2 * r}}));
    break;
  default:
    path.addEllipse(QPointF(0, 0), r, r);
  }
  return path;
}

QColor colorAt(const unsigned char* colors, int i, int components) {
  const unsigned char* c = colors + static_cast<std::ptrdiff_t>(i) * components;
  return {c[0], c[1], c[2], components == 4 ? c[3] : 255};
}

QTransform fromMatrix(vtkMatrix3x3* m) {
  return {m->GetElement(0, 0), m->GetElement(1, 0), m->GetElement(0, 1),
          m->GetElement(1, 1), m->GetElement(0, 2), m->GetElement(1, 2)};
}

} // namespace

PainterDevice* PainterDevice::New() {
  auto* device = new PainterDevice;
  device->InitializeObjectBase();
  return device;
}

void PainterDevice::paintScene(vtkContextScene& scene, QPainter& painter, int width, int height, const QColor& paper) {
  vtkNew<PainterDevice> device;
  device->begin(painter, width, height, paper);
  vtkNew<vtkContext2D> context;
  context->Begin(device);
  scene.SetGeometry(width, height);
  scene.Paint(context);
  context->End();
  device->EnableClipping(false);
}

void PainterDevice::begin(QPainter& painter, int width, int height, const QColor& paper) {
  m_painter = &painter;
  m_width = width;
  m_height = height;
  m_paper = paper;
  m_clip = QRect(0, 0, width, height);
  this->Geometry[0] = width;
  this->Geometry[1] = height;
  this->SetViewportSize(vtkVector2i(width, height));
  this->SetViewportRect(vtkRecti(0, 0, width, height));
}

QPointF PainterDevice::toPainter(float x, float y) const {
  const QPointF p = m_model.map(QPointF(static_cast<qreal>(x), static_cast<qreal>(y)));
  return {p.x(), m_height - p.y()};
}

bool PainterDevice::nearPaper(const QPointF& p) const {
  // Callers clip; what still lies beyond would make QPainter crawl (and NaN would hang it).
  const double farX = 8.0 * m_width + 1e3;
  const double farY = 8.0 * m_height + 1e3;
  return std::isfinite(p.x()) && std::isfinite(p.y()) && std::abs(p.x()) < farX && std::abs(p.y()) < farY;
}

QPen PainterDevice::currentPen() const {
  const unsigned char* c = this->Pen->GetColor();
  QPen pen(QColor(c[0], c[1], c[2], this->Pen->GetOpacity()), static_cast<qreal>(this->Pen->GetWidth()));
  switch (this->Pen->GetLineType()) {
  case vtkPen::NO_PEN:
    pen.setStyle(Qt::NoPen);
    break;
  case vtkPen::DASH_LINE:
    pen.setDashPattern({4.0, 3.0});
    break;
  case vtkPen::DOT_LINE:
  case vtkPen::DENSE_DOT_LINE:
    pen.setStyle(Qt::DotLine);
    break;
  case vtkPen::DASH_DOT_LINE:
    pen.setStyle(Qt::DashDotLine);
    break;
  case vtkPen::DASH_DOT_DOT_LINE:
    pen.setStyle(Qt::DashDotDotLine);
    break;
  default:
    break;
  }
  pen.setCapStyle(Qt::FlatCap);
  pen.setJoinStyle(Qt::RoundJoin);
  return pen;
}

QBrush PainterDevice::currentBrush() const {
  const unsigned char* c = this->Brush->GetColor();
  return {QColor(c[0], c[1], c[2], this->Brush->GetOpacity())};
}

void PainterDevice::strokeRun(const QPolygonF& run, const QPen& pen) const {
  if (run.size() < 2) {
    return;
  }
  const QTransform device = m_painter->deviceTransform();
  const double scale = std::hypot(device.m11(), device.m12());
  const bool raster = m_painter->paintEngine() != nullptr && m_painter->paintEngine()->type() == QPaintEngine::Raster;
  const double deviceWidth = pen.widthF() * scale;
  if (!raster || run.size() <= 2 * pieceLength || deviceWidth <= 1.01) {
    m_painter->setPen(pen);
    m_painter->drawPolyline(run);
    return;
  }
  const double across = std::max(1.0, std::abs(run.last().x() - run.first().x()) * scale);
  if (static_cast<double>(run.size()) > densePoints * across) {
    QPen thin(pen.color());
    thin.setCosmetic(true);
    thin.setWidthF(1.0);
    m_painter->setPen(thin);
    const double shift = 0.35 * (deviceWidth - 0.5) / scale;
    m_painter->drawPolyline(run.translated(-shift, 0.0));
    m_painter->drawPolyline(run.translated(shift, 0.0));
    if (deviceWidth > 2.0) {
      m_painter->drawPolyline(run.translated(0.0, shift));
    }
    return;
  }
  QPen piecewise = pen;
  const bool dashed = pen.style() == Qt::CustomDashLine;
  if (!dashed) {
    piecewise.setCapStyle(Qt::RoundCap); // no notches between the pieces
  }
  double before = 0.0; // length so far: the dashes go on where they ended
  for (qsizetype first = 0; first + 1 < run.size(); first += pieceLength) {
    const qsizetype count = std::min(pieceLength + 1, run.size() - first);
    if (dashed) { // setting it turns a solid pen into a dashed one
      piecewise.setDashOffset(before / pen.widthF());
    }
    m_painter->setPen(piecewise);
    m_painter->drawPolyline(run.constData() + first, static_cast<int>(count));
    for (qsizetype i = first + 1; dashed && i < first + count; ++i) {
      before += QLineF(run[i - 1], run[i]).length();
    }
  }
}

void PainterDevice::DrawPoly(float* points, int n, unsigned char* colors, int components) {
  QPen pen = currentPen();
  if (n < 2 || pen.style() == Qt::NoPen) {
    return;
  }
  if (colors != nullptr) {
    m_painter->setRenderHint(QPainter::Antialiasing, true);
    for (int i = 0; i + 1 < n; ++i) {
      pen.setColor(colorAt(colors, i, components));
      m_painter->setPen(pen);
      m_painter->drawLine(toPainter(points[2 * i], points[2 * i + 1]), toPainter(points[2 * i + 2], points[2 * i + 3]));
    }
    return;
  }
  QPolygonF run;
  run.reserve(n);
  m_painter->setRenderHint(QPainter::Antialiasing, true);
  for (int i = 0; i < n; ++i) {
    const QPointF p = toPainter(points[2 * i], points[2 * i + 1]);
    if (nearPaper(p)) {
      run << p;
    } else {
      strokeRun(run, pen);
      run.clear();
    }
  }
  if (n == 2 && run.size() == 2 && (run[0].x() == run[1].x() || run[0].y() == run[1].y())) {
    m_painter->setRenderHint(QPainter::Antialiasing, false); // axes, grid lines, ticks stay crisp
  }
  strokeRun(run, pen);
}

void PainterDevice::DrawLines(float* points, int n, unsigned char* colors, int components) {
  for (int i = 0; i + 1 < n; i += 2) {
    DrawPoly(points + static_cast<std::ptrdiff_t>(2) * i, 2,
             colors == nullptr ? nullptr : colors + static_cast<std::ptrdiff_t>(i) * components, components);
  }
}

void PainterDevice::DrawPoints(float* points, int n, unsigned char* colors, int components) {
  DrawMarkers(VTK_MARKER_CIRCLE, false, points, n, colors, components);
}

void PainterDevice::DrawPointSprites(vtkImageData* /*sprite*/, float* points, int n, unsigned char* colors,
                                     int components) {
  DrawMarkers(VTK_MARKER_CIRCLE, false, points, n, colors, components);
}

void PainterDevice::DrawMarkers(int shape, bool highlight, float* points, int n, unsigned char* colors,
                                int components) {
  const QPainterPath path = markerPath(shape, 0.5 * static_cast<double>(this->Pen->GetWidth()));
  const bool strokes = shape == VTK_MARKER_CROSS || shape == VTK_MARKER_PLUS;
  QColor color = currentPen().color();
  m_painter->setRenderHint(QPainter::Antialiasing, true);
  for (int i = 0; i < n; ++i) {
    if (colors != nullptr) {
      color = colorAt(colors, i, components);
    }
    if (i == 0 || colors != nullptr) {
      m_painter->setPen(strokes || highlight ? QPen(color, 1.6) : QPen(Qt::NoPen));
      m_painter->setBrush(strokes ? QBrush(Qt::NoBrush) : QBrush(highlight ? m_paper : color));
    }
    const QPointF center = toPainter(points[2 * i], points[2 * i + 1]);
    if (nearPaper(center)) {
      m_painter->translate(center);
      m_painter->drawPath(path);
      m_painter->translate(-center);
    }
  }
  m_painter->setBrush(Qt::NoBrush);
}

void PainterDevice::DrawQuad(float* points, int n) { DrawColoredPolygon(points, n, nullptr, 0); }

void PainterDevice::DrawQuadStrip(float* points, int n) {
  for (int i = 0; i + 3 < n; i += 2) {
    const float* p = points + static_cast<std::ptrdiff_t>(2) * i;
    std::array<float, 8> quad = {p[0], p[1], p[2], p[3], p[6], p[7], p[4], p[5]};
    DrawColoredPolygon(quad.data(), 4, nullptr, 0);
  }
}

void PainterDevice::DrawColoredPolygon(float* points, int n, unsigned char* colors, int components) {
  QPolygonF polygon;
  for (int i = 0; i < n; ++i) {
    const QPointF p = toPainter(points[2 * i], points[2 * i + 1]);
    if (!nearPaper(p)) {
      return;
    }
    polygon << p;
  }
  m_painter->setRenderHint(QPainter::Antialiasing, true);
  m_painter->setPen(Qt::NoPen);
  m_painter->setBrush(colors != nullptr ? QBrush(colorAt(colors, 0, components)) : currentBrush());
  m_painter->drawPolygon(polygon);
  m_painter->setBrush(Qt::NoBrush);
}

void PainterDevice::DrawEllipseWedge(float x, float y, float outerX, float outerY, float innerX, float innerY,
                                     float start, float stop) {
  const QPointF center = toPainter(x, y);
  const auto ellipse = [&center](float rx, float ry) {
    const QPointF r(static_cast<qreal>(rx), static_cast<qreal>(ry));
    return QRectF(center - r, center + r);
  };
  QPainterPath path;
  if (std::abs(stop - start) >= 360.0F) {
    path.addEllipse(ellipse(outerX, outerY));
  } else {
    path.moveTo(center);
    path.arcTo(ellipse(outerX, outerY), static_cast<qreal>(start), static_cast<qreal>(stop - start));
    path.closeSubpath();
  }
  if (innerX > 0.0F && innerY > 0.0F) {
    QPainterPath hole;
    hole.addEllipse(ellipse(innerX, innerY));
    path = path.subtracted(hole);
  }
  m_painter->setRenderHint(QPainter::Antialiasing, true);
  m_painter->fillPath(path, currentBrush());
}

void PainterDevice::DrawEllipticArc(float x, float y, float radiusX, float radiusY, float start, float stop) {
  const QPointF center = toPainter(x, y);
  const QPointF r(static_cast<qreal>(radiusX), static_cast<qreal>(radiusY));
  m_painter->setRenderHint(QPainter::Antialiasing, true);
  m_painter->setPen(currentPen());
  m_painter->drawArc(QRectF(center - r, center + r), static_cast<int>(std::lround(start * 16.0F)),
                     static_cast<int>(std::lround((stop - start) * 16.0F)));
}

void PainterDevice::SetColor4(unsigned char color[4]) {
  this->Pen->SetColor(color);
  this->Brush->SetColor(color);
}

void PainterDevice::SetMatrix(vtkMatrix3x3* matrix) { m_model = fromMatrix(matrix); }

void PainterDevice::GetMatrix(vtkMatrix3x3* matrix) {
  matrix->Identity();
  matrix->SetElement(0, 0, m_model.m11());
  matrix->SetElement(1, 0, m_model.m12());
  matrix->SetElement(0, 1, m_model.m21());
  matrix->SetElement(1, 1, m_model.m22());
  matrix->SetElement(0, 2, m_model.dx());
  matrix->SetElement(1, 2, m_model.dy());
}

void PainterDevice::MultiplyMatrix(vtkMatrix3x3* matrix) { m_model = fromMatrix(matrix) * m_model; }

void PainterDevice::PushMatrix() { m_stack.push_back(m_model); }

void PainterDevice::PopMatrix() {
  m_model = m_stack.back();
  m_stack.pop_back();
}

void PainterDevice::SetClipping(int* rect) {
  // A marker on the border stays whole; lines and bars come cut already.
  m_clip = QRect(rect[0], m_height - rect[1] - rect[3], rect[2], rect[3]).adjusted(-6, -6, 6, 6);
  if (m_clipping) {
    EnableClipping(true);
  }
}

void PainterDevice::EnableClipping(bool enable) {
  // The painter may be clipped already by whoever called: narrow that clip, and restore it afterwards.
  if (m_clipping) {
    m_painter->restore();
  }
  if (enable) {
    m_painter->save();
    m_painter->setClipRect(m_clip, Qt::IntersectClip);
  }
  m_clipping = enable;
}

} // namespace straightedge::gui
