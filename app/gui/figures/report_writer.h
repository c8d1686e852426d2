// Puts a report together: numbers figures and tables as they are added.
#pragma once

#include "app/gui/figures/report_content.h"

namespace straightedge::gui {

class ReportWriter {
public:
  /// Without `pictures` three-dimensional figures are left out.
  explicit ReportWriter(ReportContent& content, ScenePictures* pictures = nullptr)
      : m_content(content), m_pictures(pictures) {}

  void heading(const QString& text);
  void paragraph(const QString& text, ReportParagraph::Tone tone = ReportParagraph::Tone::Plain);
  void facts(ReportTable table); ///< without a number
  void table(ReportTable table);
  void figures(const QList<NamedFigure>& all, FigureTopic topic);
  /// A heading only where figures follow.
  void section(const QString& text, const QList<NamedFigure>& all, FigureTopic topic);

private:
  void scene(const NamedFigure& figure);

  ReportContent& m_content;
  ScenePictures* m_pictures;
  bool m_missingSaid = false; ///< that three-dimensional figures are missing
  int m_figures = 0;
  int m_tables = 0;
};

/// Title and subtitle of a report about this device; `otherwise` where it has no name.
QString reportSubtitle(const Traceability& traceability, const std::string& otherwise);

} // namespace straightedge::gui
