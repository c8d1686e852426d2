// The report as data: headings, paragraphs, tables and figures in reading order. The PDF and the HTML page are both
// made from it.
#pragma once

#include "app/gui/figures/angle_figures.h"
#include "app/gui/figures/field_figures.h"

#include <QByteArray>
#include <QList>
#include <QString>
#include <QStringList>

#include <optional>
#include <variant>

namespace straightedge::gui {

class ScenePictures;

struct ReportHeading {
  QString text;
};

struct ReportParagraph {
  enum class Tone : std::uint8_t { Plain, Warning, Good, Bad };
  QString text;
  Tone tone = Tone::Plain;
};

struct ReportTable {
  QString caption;    ///< "Table 2. …"; empty for a table of facts
  QStringList header; ///< empty for a table of facts: first column says what, second its value
  QList<QStringList> rows;
  int firstNumericColumn = 1; ///< columns from here on are aligned to the right
  int lastNumericColumn = 99;
};

struct ReportFigure {
  QString caption;     ///< "Figure 3. …"
  PlotSpec spec;       ///< without title and note: the caption says both
  QByteArray png = {}; ///< instead of `spec`: a three-dimensional picture
};

using ReportBlock = std::variant<ReportHeading, ReportParagraph, ReportTable, ReportFigure>;

struct ReportContent {
  QString title;    ///< "Angle calibration"
  QString subtitle; ///< device model and serial
  QString software;
  QString created;
  QList<ReportBlock> blocks;
};

/// Everything there is to say about one angle calibration.
ReportContent angleReport(const std::shared_ptr<const AngleResults>& results);
/// Everything there is to say about one field calibration. Without `pictures` the three-dimensional ones are left out;
/// where they cannot be drawn the report says so.
ReportContent fieldReport(const std::shared_ptr<const FieldResults>& results, ScenePictures* pictures = nullptr);

} // namespace straightedge::gui
