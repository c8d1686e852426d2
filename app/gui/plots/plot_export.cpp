#include "app/gui/plots/plot_export.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QFileInfo>
#include <QPainter>
#include <QPdfWriter>
#include <QSaveFile>
#include <QSvgGenerator>

#include <algorithm>
#include <cmath>

namespace straightedge::gui {
namespace {

constexpr double pixelsPerInch = 96.0;

QByteArray asPng(const QSize& size, const PaintPlot& paint) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  QImage image = paintToImage(size, 2.0, paint);
  image.setDotsPerMeterX(static_cast<int>(std::lround(2.0 * pixelsPerInch / 0.0254)));
  image.setDotsPerMeterY(image.dotsPerMeterX());
  image.save(&buffer, "PNG");
  return bytes;
}

QByteArray asSvg(const QSize& size, const QString& title, const PaintPlot& paint) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  QSvgGenerator svg;
  svg.setOutputDevice(&buffer);
  svg.setSize(size);
  svg.setViewBox(QRect(QPoint(0, 0), size));
  svg.setResolution(static_cast<int>(pixelsPerInch));
  svg.setTitle(title);
  QPainter painter(&svg);
  paint(painter, QRectF(QPointF(0, 0), size));
  painter.end();
  return bytes;
}

QByteArray asPdf(const QSize& size, const QString& title, const PaintPlot& paint) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter pdf(&buffer);
  pdf.setPageSize(QPageSize(QSizeF(size) * (72.0 / pixelsPerInch), QPageSize::Point, QString(), QPageSize::ExactMatch));
  pdf.setPageMargins(QMarginsF());
  pdf.setTitle(title);
  pdf.setCreator(QStringLiteral("Straightedge"));
  QPainter painter(&pdf);
  const double scale = pdf.width() / static_cast<double>(size.width());
  painter.scale(scale, scale);
  paint(painter, QRectF(QPointF(0, 0), size));
  painter.end();
  return bytes;
}

} // namespace

QImage paintToImage(const QSize& size, double scale, const PaintPlot& paint) {
  const QSize pixels(std::max(1, static_cast<int>(std::lround(size.width() * scale))),
                     std::max(1, static_cast<int>(std::lround(size.height() * scale))));
  QImage image(pixels, QImage::Format_ARGB32_Premultiplied);
  image.setDevicePixelRatio(scale);
  image.fill(Qt::transparent);
  QPainter painter(&image);
  paint(painter, QRectF(QPointF(0, 0), size));
  painter.end();
  return image;
}

bool paintToFile(const QString& file, const QSize& size, const QString& title, const PaintPlot& paint,
                 QString* problem) {
  const auto complain = [problem](const QString& sentence) {
    if (problem != nullptr) {
      *problem = sentence;
    }
    return false;
  };
  const QString extension = QFileInfo(file).suffix().toLower();
  QByteArray bytes;
  if (extension == QStringLiteral("png")) {
    bytes = asPng(size, paint);
  } else if (extension == QStringLiteral("svg")) {
    bytes = asSvg(size, title, paint);
  } else if (extension == QStringLiteral("pdf")) {
    bytes = asPdf(size, title, paint);
  } else {
    return complain(QCoreApplication::translate("Plot", "“%1” does not end in .png, .svg or .pdf; choose one of these.")
                        .arg(QFileInfo(file).fileName()));
  }
  QSaveFile out(file);
  if (!out.open(QIODevice::WriteOnly) || out.write(bytes) != bytes.size() || !out.commit()) {
    return complain(
        QCoreApplication::translate("Plot", "The picture cannot be written to “%1”: %2. Choose another place.")
            .arg(file, out.errorString()));
  }
  return true;
}

} // namespace straightedge::gui
