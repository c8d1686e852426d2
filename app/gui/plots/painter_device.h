// VTK's two-dimensional drawing on a QPainter: charts on widgets, images, SVG and PDF from the same code, without
// OpenGL.
#pragma once

#include <QBrush>
#include <QColor>
#include <QFont>
#include <QPen>
#include <QRect>
#include <QTransform>
#include <vtkContextDevice2D.h>
#include <vtkVersionMacros.h>

#include <vector>

class QPainter;
class vtkContextScene;

namespace straightedge::gui {

/// One pen width, font size or length of 1 is one logical pixel of the painter; VTK's y points up, the painter's down.
/// Any thread; a device belongs to one painter at a time.
class PainterDevice : public vtkContextDevice2D {
public:
  static PainterDevice* New();
  PainterDevice(const PainterDevice&) = delete;
  PainterDevice& operator=(const PainterDevice&) = delete;

  /// Paints the scene into width × height logical pixels from the painter's origin.
  static void paintScene(vtkContextScene& scene, QPainter& painter, int width, int height, const QColor& paper);

  void DrawPoly(float* points, int n, unsigned char* colors, int components) override;
  void DrawLines(float* points, int n, unsigned char* colors, int components) override;
  void DrawPoints(float* points, int n, unsigned char* colors, int components) override;
  void DrawPointSprites(vtkImageData* sprite, float* points, int n, unsigned char* colors, int components) override;
  /// `highlight` draws hollow: outline in the pen's colour, filled with the paper's.
  void DrawMarkers(int shape, bool highlight, float* points, int n, unsigned char* colors, int components) override;
  void DrawQuad(float* points, int n) override;
  void DrawQuadStrip(float* points, int n) override;
  void DrawColoredPolygon(float* points, int n, unsigned char* colors, int components) override;
  void DrawEllipseWedge(float x, float y, float outerX, float outerY, float innerX, float innerY, float start,
                        float stop) override;
  void DrawEllipticArc(float x, float y, float radiusX, float radiusY, float start, float stop) override;
  void DrawString(float* point, const vtkStdString& text) override;
  void ComputeStringBounds(const vtkStdString& text, float bounds[4]) override;
  void ComputeJustifiedStringBounds(const char* text, float bounds[4]) override;
  void DrawMathTextString(float* point, const vtkStdString& text) override;
#if VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION < 2
  void DrawString(float* point, const vtkUnicodeString& text) override;
  void ComputeStringBounds(const vtkUnicodeString& text, float bounds[4]) override;
#endif
  void DrawImage(float p[2], float scale, vtkImageData* image) override;
  void DrawImage(const vtkRectf& place, vtkImageData* image) override;
  void SetColor4(unsigned char color[4]) override;
  void SetTexture(vtkImageData* /*image*/, int /*properties*/) override {}
  void SetPointSize(float /*size*/) override {}
  void SetLineWidth(float /*width*/) override {}
  void SetLineType(int /*type*/) override {}
  void SetMatrix(vtkMatrix3x3* matrix) override;
  void GetMatrix(vtkMatrix3x3* matrix) override;
  void MultiplyMatrix(vtkMatrix3x3* matrix) override;
  void PushMatrix() override;
  void PopMatrix() override;
  void SetClipping(int* rect) override;
  void EnableClipping(bool enable) override;

  /// Marker shape without a counterpart in VTK.
  static constexpr int triangleMarker = 100;

vtkTypeMacro(PainterDevice, vtkContextDevice2D)

    protected : PainterDevice() = default;
  ~PainterDevice() override = default;

private:
  void begin(QPainter& painter, int width, int height, const QColor& paper);
  QPointF toPainter(float x, float y) const;
  bool nearPaper(const QPointF& point) const;
  void strokeRun(const QPolygonF& run, const QPen& pen) const;
  QPen currentPen() const;
  QBrush currentBrush() const;
  QFont currentFont() const;
  QSizeF textSize(const QString& text) const;
  void drawText(const float* point, const QString& text) const;

  QPainter* m_painter = nullptr;
  int m_width = 0, m_height = 0;
  QColor m_paper;
  QTransform m_model;
  std::vector<QTransform> m_stack;
  QRect m_clip;
  bool m_clipping = false;
};

} // namespace straightedge::gui
