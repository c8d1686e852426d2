// Text and images of the painter device: fonts by Qt, so that every sign is there by font fallback.
#include "app/gui/plots/painter_device.h"

#include <QFontMetricsF>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <QStringList>
#include <vtkImageData.h>
#include <vtkRect.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#if VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION < 2
#include <vtkUnicodeString.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace straightedge::gui {
namespace {

QImage toImage(vtkImageData* image) {
  std::array<int, 3> size{};
  image->GetDimensions(size.data());
  const int components = image->GetNumberOfScalarComponents();
  if (image->GetScalarType() != VTK_UNSIGNED_CHAR || components < 3) {
    return {};
  }
  QImage result(size[0], size[1], QImage::Format_RGBA8888);
  const auto* from = static_cast<const unsigned char*>(image->GetScalarPointer());
  for (int y = size[1] - 1; y >= 0; --y) { // VTK's first row is the lowest
    unsigned char* to = result.scanLine(y);
    for (int x = 0; x < size[0]; ++x, from += components, to += 4) {
      std::copy_n(from, 3, to);
      to[3] = components == 4 ? from[3] : 255;
    }
  }
  return result;
}

} // namespace

QFont PainterDevice::currentFont() const {
  QFont font = QGuiApplication::font();
  font.setPixelSize(std::max(1, this->TextProp->GetFontSize()));
  font.setBold(this->TextProp->GetBold() != 0);
  font.setItalic(this->TextProp->GetItalic() != 0);
  return font;
}

QSizeF PainterDevice::textSize(const QString& text) const {
  const QFontMetricsF metrics(currentFont());
  const QStringList lines = text.split(u'\n');
  double width = 0.0;
  for (const QString& line : lines) {
    width = std::max(width, metrics.horizontalAdvance(line));
  }
  return {width, metrics.height() + static_cast<double>(lines.size() - 1) * metrics.lineSpacing()};
}

void PainterDevice::drawText(const float* point, const QString& text) const {
  const QFont font = currentFont();
  const QFontMetricsF metrics(font);
  const QSizeF size = textSize(text);
  std::array<double, 3> rgb{};
  this->TextProp->GetColor(rgb.data());
  QPointF corner; // upper left, relative to the anchor
  switch (this->TextProp->GetJustification()) {
  case VTK_TEXT_CENTERED:
    corner.setX(-size.width() / 2);
    break;
  case VTK_TEXT_RIGHT:
    corner.setX(-size.width());
    break;
  default:
    break;
  }
  switch (this->TextProp->GetVerticalJustification()) {
  case VTK_TEXT_CENTERED:
    corner.setY(-size.height() / 2);
    break;
  case VTK_TEXT_TOP:
    break;
  default:
    corner.setY(-size.height());
  }
  m_painter->save();
  m_painter->translate(toPainter(point[0], point[1]));
  m_painter->rotate(-this->TextProp->GetOrientation());
  m_painter->setFont(font);
  m_painter->setPen(QColor::fromRgbF(static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2]),
                                     static_cast<float>(this->TextProp->GetOpacity())));
  double baseline = corner.y() + metrics.ascent();
  for (const QString& line : text.split(u'\n')) {
    m_painter->drawText(QPointF(corner.x(), baseline), line);
    baseline += metrics.lineSpacing();
  }
  m_painter->restore();
}

void PainterDevice::DrawString(float* point, const vtkStdString& text) {
  drawText(point, QString::fromStdString(text));
}

void PainterDevice::DrawMathTextString(float* point, const vtkStdString& text) { DrawString(point, text); }

void PainterDevice::ComputeStringBounds(const vtkStdString& text, float bounds[4]) {
  const QSizeF size = textSize(QString::fromStdString(text));
  const double angle = this->TextProp->GetOrientation() * std::numbers::pi / 180.0;
  const double c = std::abs(std::cos(angle));
  const double s = std::abs(std::sin(angle));
  bounds[0] = bounds[1] = 0.0F;
  bounds[2] = static_cast<float>((size.width() * c + size.height() * s) / std::abs(m_model.m11()));
  bounds[3] = static_cast<float>((size.width() * s + size.height() * c) / std::abs(m_model.m22()));
}

void PainterDevice::ComputeJustifiedStringBounds(const char* text, float bounds[4]) {
  ComputeStringBounds(vtkStdString(text), bounds);
  switch (this->TextProp->GetJustification()) {
  case VTK_TEXT_CENTERED:
    bounds[0] = -bounds[2] / 2.0F;
    break;
  case VTK_TEXT_RIGHT:
    bounds[0] = -bounds[2];
    break;
  default:
    break;
  }
  switch (this->TextProp->GetVerticalJustification()) {
  case VTK_TEXT_CENTERED:
    bounds[1] = -bounds[3] / 2.0F;
    break;
  case VTK_TEXT_TOP:
    bounds[1] = -bounds[3];
    break;
  default:
    break;
  }
}

#if VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION < 2
void PainterDevice::DrawString(float* point, const vtkUnicodeString& text) {
  drawText(point, QString::fromUtf8(text.utf8_str()));
}

void PainterDevice::ComputeStringBounds(const vtkUnicodeString& text, float bounds[4]) {
  ComputeStringBounds(vtkStdString(text.utf8_str()), bounds);
}
#endif

void PainterDevice::DrawImage(float p[2], float scale, vtkImageData* image) {
  const QImage picture = toImage(image);
  const QPointF lowerLeft = toPainter(p[0], p[1]);
  const QSizeF size = QSizeF(picture.size()) * static_cast<qreal>(scale);
  m_painter->drawImage(QRectF(lowerLeft - QPointF(0, size.height()), size), picture);
}

void PainterDevice::DrawImage(const vtkRectf& place, vtkImageData* image) {
  const QPointF a = toPainter(place.GetX(), place.GetY());
  const QPointF b = toPainter(place.GetX() + place.GetWidth(), place.GetY() + place.GetHeight());
  m_painter->drawImage(QRectF(a, b).normalized(), toImage(image));
}

} // namespace straightedge::gui
