#include "app/gui/figures/report_writer.h"

#include "app/gui/figures/figure_parts.h"
#include "app/gui/figures/scene_pictures.h"

#include <algorithm>
#include <utility>

namespace straightedge::gui {

void ReportWriter::heading(const QString& text) { m_content.blocks.append(ReportHeading{text}); }

void ReportWriter::paragraph(const QString& text, ReportParagraph::Tone tone) {
  m_content.blocks.append(ReportParagraph{text, tone});
}

void ReportWriter::facts(ReportTable table) {
  table.caption.clear();
  m_content.blocks.append(std::move(table));
}

void ReportWriter::table(ReportTable table) {
  table.caption = QStringLiteral("Table %1. %2.").arg(++m_tables).arg(table.caption);
  m_content.blocks.append(std::move(table));
}

void ReportWriter::figures(const QList<NamedFigure>& all, FigureTopic topic) {
  for (const NamedFigure& figure : all) {
    if (figure.topic != topic) {
      continue;
    }
    if (figure.isScene()) {
      scene(figure);
      continue;
    }
    ReportFigure block{QStringLiteral("Figure %1. %2").arg(++m_figures).arg(figure.caption), figure.make(), {}};
    if (!block.spec.note.isEmpty()) {
      block.caption += QLatin1Char(' ') + block.spec.note + QLatin1Char('.');
    }
    block.spec.title.clear();
    block.spec.note.clear();
    m_content.blocks.append(std::move(block));
  }
}

void ReportWriter::scene(const NamedFigure& figure) {
  if (m_pictures == nullptr) {
    return;
  }
  if (const QByteArray png = m_pictures->png(figure); !png.isEmpty()) {
    m_content.blocks.append(
        ReportFigure{QStringLiteral("Figure %1. %2").arg(++m_figures).arg(figure.caption), PlotSpec{}, png});
  } else if (!std::exchange(m_missingSaid, true)) {
    paragraph(QStringLiteral("The three-dimensional pictures are missing from this report. ") + m_pictures->problem(),
              ReportParagraph::Tone::Warning);
  }
}

void ReportWriter::section(const QString& text, const QList<NamedFigure>& all, FigureTopic topic) {
  if (std::ranges::any_of(all, [topic](const NamedFigure& figure) { return figure.topic == topic; })) {
    heading(text);
    figures(all, topic);
  }
}

QString reportSubtitle(const Traceability& traceability, const std::string& otherwise) {
  QStringList device;
  for (const std::string& part : {traceability.deviceModel, traceability.deviceSerial}) {
    if (!part.empty()) {
      device << fromText(part);
    }
  }
  return device.isEmpty() ? fromText(otherwise) : device.join(QStringLiteral(" · "));
}

} // namespace straightedge::gui
