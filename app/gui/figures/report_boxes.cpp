#include "app/gui/figures/report_boxes.h"

#include "app/gui/plots/plot_view.h"

#include <QFont>
#include <QImage>
#include <QPainter>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextOption>

#include <memory>

namespace straightedge::gui {

namespace {

constexpr int bodyPixels = 13;
constexpr int captionPixels = 12;
constexpr double figureShare = 0.38; ///< height of a figure as a share of the text width: three to a page
constexpr double sceneShare = 0.52;  ///< of a three-dimensional one

std::shared_ptr<QTextDocument> wrapped(const QString& text, const QFont& font, double width) {
  auto document = std::make_shared<QTextDocument>();
  document->setDocumentMargin(0.0);
  document->setUseDesignMetrics(true);
  document->setDefaultFont(font);
  QTextOption option;
  option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
  document->setDefaultTextOption(option);
  document->setPlainText(text);
  document->setTextWidth(width);
  return document;
}

} // namespace

QFont reportFont(int pixels, bool bold) {
  QFont font(QStringLiteral("DejaVu Sans"));
  font.setStyleHint(QFont::SansSerif);
  font.setPixelSize(pixels);
  font.setHintingPreference(QFont::PreferNoHinting);
  font.setBold(bold);
  return font;
}

ReportBox textBox(const QString& text, const QFont& font, const QColor& color, double width) {
  const std::shared_ptr<QTextDocument> document = wrapped(text, font, width);
  QTextCursor cursor(document.get());
  cursor.select(QTextCursor::Document);
  QTextCharFormat format;
  format.setForeground(color);
  cursor.mergeCharFormat(format);
  ReportBox box;
  box.height = document->size().height();
  box.draw = [document](QPainter& painter, QPointF at) {
    painter.save();
    painter.translate(at);
    document->drawContents(&painter);
    painter.restore();
  };
  return box;
}

void addTitle(QList<ReportBox>& boxes, const ReportContent& content, double width) {
  boxes.append(textBox(content.title, reportFont(26, true), reportInk, width));
  ReportBox subtitle = textBox(content.subtitle, reportFont(15), reportQuietInk, width);
  subtitle.spaceBefore = 2.0;
  boxes.append(subtitle);
}

void addBoxes(QList<ReportBox>& boxes, const ReportHeading& heading, double width) {
  ReportBox text = textBox(heading.text, reportFont(17, true), reportInk, width);
  ReportBox box;
  box.height = text.height + 9.0;
  box.spaceBefore = 24.0;
  box.keepWithNext = true;
  box.draw = [text, width](QPainter& painter, QPointF at) {
    painter.setPen(QPen(QColor(0xd5, 0xda, 0xe2), 1.0));
    painter.drawLine(at, at + QPointF(width, 0.0));
    text.draw(painter, at + QPointF(0.0, 8.0));
  };
  boxes.append(box);
}

void addBoxes(QList<ReportBox>& boxes, const ReportParagraph& paragraph, double width) {
  using Tone = ReportParagraph::Tone;
  if (paragraph.tone == Tone::Plain) {
    ReportBox box = textBox(paragraph.text, reportFont(bodyPixels), reportInk, width);
    box.spaceBefore = 10.0;
    boxes.append(box);
    return;
  }
  constexpr double padding = 9.0;
  constexpr double bar = 4.0;
  const ReportBox text = textBox(paragraph.text, reportFont(bodyPixels), reportInk, width - 2.0 * padding - bar);
  const QColor edge = paragraph.tone == Tone::Warning ? QColor(0xd9, 0x93, 0x0d)
                      : paragraph.tone == Tone::Good  ? QColor(0x2e, 0x8b, 0x57)
                                                      : QColor(0xc0, 0x39, 0x2b);
  const QColor fill = paragraph.tone == Tone::Warning ? QColor(0xff, 0xf7, 0xe6)
                      : paragraph.tone == Tone::Good  ? QColor(0xea, 0xf7, 0xf0)
                                                      : QColor(0xfd, 0xee, 0xec);
  ReportBox box;
  box.height = text.height + 2.0 * padding;
  box.spaceBefore = 10.0;
  box.draw = [text, edge, fill, width, height = box.height](QPainter& painter, QPointF at) {
    painter.fillRect(QRectF(at, QSizeF(width, height)), fill);
    painter.fillRect(QRectF(at, QSizeF(bar, height)), edge);
    text.draw(painter, at + QPointF(bar + padding, padding));
  };
  boxes.append(box);
}

void addBoxes(QList<ReportBox>& boxes, const ReportFigure& figure, double width) {
  const ReportBox caption = textBox(figure.caption, reportFont(captionPixels), reportQuietInk, width);
  const bool scene = !figure.png.isEmpty();
  const QSizeF plot(width, width * (scene ? sceneShare : figureShare));
  constexpr double between = 4.0;
  ReportBox box;
  box.height = plot.height() + between + caption.height;
  box.spaceBefore = 16.0;
  box.draw = [caption, plot, spec = figure.spec, png = figure.png](QPainter& painter, QPointF at) {
    painter.save();
    if (png.isEmpty()) {
      paintPlot(painter, QRectF(at, plot), spec, PlotTheme::Light);
    } else {
      const QImage image = QImage::fromData(png, "PNG");
      const QSizeF drawn = QSizeF(image.size()).scaled(plot, Qt::KeepAspectRatio);
      painter.drawImage(QRectF(at + QPointF(0.5 * (plot.width() - drawn.width()), 0.0), drawn), image);
    }
    painter.restore();
    caption.draw(painter, at + QPointF(0.0, plot.height() + between));
  };
  boxes.append(box);
}

} // namespace straightedge::gui
