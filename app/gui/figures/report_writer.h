// Puts a report together: numbers figures and tables as they are added.
#pragma once

#include "app/gui/figures/report_content.h"

namespace straightedge::gui {

class ReportWriter {
public:
  explicit ReportWriter(ReportContent& content) : m_content(content) {}

  void heading(const QString& text);
  void paragraph(const QString& text, ReportParagraph::Tone tone = ReportParagraph::Tone::Plain);
  void facts(ReportTable table); ///< without a number
  void table(ReportTable table);
  void figures(const QList<NamedFigure>& all, FigureTopic topic);
  /// A heading only where figures follow.
  void section(const QString& text, const QList<NamedFigure>& all, FigureTopic topic);

private:
  ReportContent& m_content;
  int m_figures = 0;
  int m_tables = 0;
};

/// Title and subtitle of a report about this device; `otherwise` where it has no name.
QString reportSubtitle(const Traceability& traceability, const std::string& otherwise);

} // namespace straightedge::gui
