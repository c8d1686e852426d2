#include "app/gui/figures/report_html.h"

#include "app/gui/figures/picture_files.h"

namespace straightedge::gui {

namespace {

const char* const style = R"(
:root { color-scheme: light; }
body { font: 15px/1.5 system-ui, "Segoe UI", "DejaVu Sans", sans-serif; color: #1d2430; background: #fff;
       max-width: 60rem; margin: 2.5rem auto; padding: 0 1.5rem; }
h1 { font-size: 1.9rem; margin: 0; font-weight: 650; }
h2 { font-size: 1.25rem; margin: 2.6rem 0 .8rem; padding-top: .8rem; border-top: 1px solid #d5dae2; font-weight: 650; }
.subtitle { color: #5a6473; font-size: 1.1rem; margin: .2rem 0 1.6rem; }
table { border-collapse: collapse; margin: .6rem 0 1.4rem; font-size: .88rem; font-variant-numeric: tabular-nums; }
th, td { padding: .28rem .9rem .28rem 0; text-align: left; vertical-align: top; overflow-wrap: anywhere; }
th { border-bottom: 1.5px solid #1d2430; font-weight: 600; white-space: nowrap; }
td { border-bottom: 1px solid #e6e9ee; }
td.number, th.number { text-align: right; }
table.facts td:first-child { color: #5a6473; white-space: nowrap; }
caption { caption-side: top; text-align: left; color: #5a6473; padding-bottom: .3rem; }
figure { margin: 1.2rem 0 1.8rem; break-inside: avoid; }
figure img { width: 100%; height: auto; display: block; }
figcaption { color: #5a6473; font-size: .88rem; margin-top: .4rem; }
p.warning, p.good, p.bad { border-left: 4px solid; padding: .5rem .9rem; margin: .8rem 0; }
p.warning { border-color: #d9930d; background: #fff7e6; }
p.good { border-color: #2e8b57; background: #eaf7f0; }
p.bad { border-color: #c0392b; background: #fdeeec; }
footer { color: #5a6473; font-size: .82rem; margin-top: 3rem; border-top: 1px solid #d5dae2; padding-top: .8rem; }
@media print { body { margin: 0; max-width: none; } h2 { break-after: avoid; } }
)";

QString escaped(const QString& text) { return text.toHtmlEscaped(); }

QString html(const ReportHeading& heading) { return QStringLiteral("<h2>%1</h2>\n").arg(escaped(heading.text)); }

QString html(const ReportParagraph& paragraph) {
  using Tone = ReportParagraph::Tone;
  const QString tone = paragraph.tone == Tone::Warning ? QStringLiteral(" class=\"warning\"")
                       : paragraph.tone == Tone::Good  ? QStringLiteral(" class=\"good\"")
                       : paragraph.tone == Tone::Bad   ? QStringLiteral(" class=\"bad\"")
                                                       : QString();
  return QStringLiteral("<p") + tone + QLatin1Char('>') + escaped(paragraph.text) + QStringLiteral("</p>\n");
}

QString htmlRow(const ReportTable& table, const QStringList& cells, const QString& tag) {
  QString row = QStringLiteral("<tr>");
  for (int c = 0; c < cells.size(); ++c) {
    const bool numeric = c >= table.firstNumericColumn && c <= table.lastNumericColumn;
    row += QLatin1Char('<') + tag + (numeric ? QStringLiteral(" class=\"number\">") : QStringLiteral(">")) +
           escaped(cells[c]) + QStringLiteral("</") + tag + QLatin1Char('>');
  }
  return row + QStringLiteral("</tr>\n");
}

QString html(const ReportTable& table) {
  QString text = table.header.isEmpty() ? QStringLiteral("<table class=\"facts\">\n") : QStringLiteral("<table>\n");
  if (!table.caption.isEmpty()) {
    text += QStringLiteral("<caption>") + escaped(table.caption) + QStringLiteral("</caption>\n");
  }
  if (!table.header.isEmpty()) {
    text +=
        QStringLiteral("<thead>") + htmlRow(table, table.header, QStringLiteral("th")) + QStringLiteral("</thead>\n");
  }
  text += QStringLiteral("<tbody>\n");
  for (const QStringList& row : table.rows) {
    text += htmlRow(table, row, QStringLiteral("td"));
  }
  return text + QStringLiteral("</tbody></table>\n");
}

QString html(const ReportFigure& figure) {
  const QString source =
      figure.png.isEmpty() ? QStringLiteral("svg+xml;base64,") + QString::fromLatin1(plotAsSvg(figure.spec).toBase64())
                           : QStringLiteral("png;base64,") + QString::fromLatin1(figure.png.toBase64());
  return QStringLiteral("<figure><img alt=\"") + escaped(figure.caption) + QStringLiteral("\" src=\"data:image/") +
         source + QStringLiteral("\"><figcaption>") + escaped(figure.caption) +
         QStringLiteral("</figcaption></figure>\n");
}

} // namespace

QByteArray reportAsHtml(const ReportContent& content) {
  QString page = QStringLiteral("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
                                "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>");
  page += escaped(content.title + QStringLiteral(" – ") + content.subtitle) + QStringLiteral("</title>\n<style>") +
          QString::fromLatin1(style) + QStringLiteral("</style></head><body>\n");
  page += QStringLiteral("<h1>") + escaped(content.title) + QStringLiteral("</h1>\n<p class=\"subtitle\">") +
          escaped(content.subtitle) + QStringLiteral("</p>\n");
  for (const ReportBlock& block : content.blocks) {
    page += std::visit([](const auto& each) { return html(each); }, block);
  }
  page += QStringLiteral("<footer>") + escaped(content.software + QStringLiteral(" · ") + content.created) +
          QStringLiteral("</footer>\n</body></html>\n");
  return page.toUtf8();
}

} // namespace straightedge::gui
