#include "app/gui/figures/report_pdf.h"

#include "app/gui/figures/report_boxes.h"
#include "app/gui/figures/report_layout.h"

#include <QBuffer>
#include <QFontMetricsF>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>

namespace straightedge::gui {

namespace {

constexpr double pageDpi = 96.0;
constexpr int pageFileDpi = 1200;
constexpr double perMm = pageDpi / 25.4;
constexpr QSizeF paperMm{210.0, 297.0};
constexpr double sideMm = 20.0;
constexpr double topMm = 22.0;
constexpr double bottomMm = 22.0;
constexpr double edgeLineMm = 12.0; ///< distance of header and footer from the paper's edge

void drawEdges(QPainter& painter, const ReportContent& content, qsizetype page, qsizetype pages) {
  const QFont font = reportFont(10);
  painter.setFont(font);
  painter.setPen(QColor(0x5a, 0x64, 0x73));
  const double left = sideMm * perMm;
  const double width = (paperMm.width() - 2.0 * sideMm) * perMm;
  const double lineHeight = QFontMetricsF(font).height();
  const auto line = [&](double topOfLine, Qt::Alignment alignment, const QString& text) {
    painter.drawText(QRectF(left, topOfLine, width, lineHeight), static_cast<int>(alignment), text);
  };
  if (page > 0) {
    line(edgeLineMm * perMm, Qt::AlignLeft, content.title + QStringLiteral(" · ") + content.subtitle);
  }
  const double foot = (paperMm.height() - edgeLineMm) * perMm - lineHeight;
  line(foot, Qt::AlignLeft, content.software + QStringLiteral(" · ") + content.created);
  line(foot, Qt::AlignRight, QStringLiteral("page %1 of %2").arg(page + 1).arg(pages));
}

} // namespace

QByteArray reportAsPdf(const ReportContent& content) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter writer(&buffer);
  writer.setTitle(content.title + QStringLiteral(" – ") + content.subtitle);
  writer.setCreator(content.software);
  writer.setResolution(pageFileDpi);
  writer.setPageSize(QPageSize(QPageSize::A4));
  writer.setPageMargins({});
  const double width = (paperMm.width() - 2.0 * sideMm) * perMm;
  const double height = (paperMm.height() - topMm - bottomMm) * perMm;
  const QList<ReportBox> boxes = reportBoxes(content, width);
  const QList<QList<PlacedBox>> pages = paginate(boxes, height);
  QPainter painter(&writer);
  for (qsizetype page = 0; page < pages.size(); ++page) {
    if (page > 0) {
      writer.newPage();
    }
    painter.save();
    painter.scale(pageFileDpi / pageDpi, pageFileDpi / pageDpi);
    drawEdges(painter, content, page, pages.size());
    for (const PlacedBox& placed : pages[page]) {
      boxes[placed.box].draw(painter, QPointF(sideMm, topMm) * perMm + QPointF(0.0, placed.y));
    }
    painter.restore();
  }
  painter.end();
  return bytes;
}

} // namespace straightedge::gui
