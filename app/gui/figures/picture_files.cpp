#include "app/gui/figures/picture_files.h"

#include <QBuffer>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgGenerator>

namespace straightedge::gui {

namespace {

/// Plots are drawn in logical pixels of 1/96 inch, as browsers and PDF viewers understand a pixel.
constexpr double logicalDpi = 96.0;
constexpr int pdfDpi = 1200;

QColor paperColor(PlotTheme theme) { return theme == PlotTheme::Dark ? QColor(0x1e, 0x1f, 0x22) : QColor(Qt::white); }

} // namespace

QString suffixOf(PictureFormat format) {
  switch (format) {
  case PictureFormat::Png:
    return QStringLiteral("png");
  case PictureFormat::Svg:
    return QStringLiteral("svg");
  case PictureFormat::Pdf:
    return QStringLiteral("pdf");
  }
  return {};
}

QByteArray plotAsPng(const PlotSpec& spec, QSize size, double scale, PlotTheme theme) {
  QImage image((QSizeF(size) * scale).toSize(), QImage::Format_ARGB32_Premultiplied);
  image.setDevicePixelRatio(scale);
  image.fill(paperColor(theme));
  {
    QPainter painter(&image);
    paintPlot(painter, QRectF(QPointF(), QSizeF(size)), spec, theme);
  }
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return bytes;
}

QByteArray plotAsSvg(const PlotSpec& spec, QSize size, PlotTheme theme) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  QSvgGenerator generator;
  generator.setOutputDevice(&buffer);
  generator.setSize(size);
  generator.setViewBox(QRect(QPoint(), size));
  generator.setTitle(spec.title);
  generator.setResolution(static_cast<int>(logicalDpi));
  QPainter painter(&generator);
  paintPlot(painter, QRectF(QPointF(), QSizeF(size)), spec, theme);
  painter.end();
  return bytes;
}

QByteArray plotAsPdf(const PlotSpec& spec, QSize size, PlotTheme theme) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter writer(&buffer);
  writer.setTitle(spec.title);
  writer.setCreator(QStringLiteral("Straightedge " STRAIGHTEDGE_VERSION));
  writer.setResolution(pdfDpi);
  writer.setPageSize(QPageSize(QSizeF(size) * 72.0 / logicalDpi, QPageSize::Point));
  writer.setPageMargins({});
  QPainter painter(&writer);
  painter.scale(pdfDpi / logicalDpi, pdfDpi / logicalDpi);
  paintPlot(painter, QRectF(QPointF(), QSizeF(size)), spec, theme);
  painter.end();
  return bytes;
}

QByteArray plotAs(PictureFormat format, const PlotSpec& spec) {
  switch (format) {
  case PictureFormat::Png:
    return plotAsPng(spec);
  case PictureFormat::Svg:
    return plotAsSvg(spec);
  case PictureFormat::Pdf:
    return plotAsPdf(spec);
  }
  return {};
}

} // namespace straightedge::gui
