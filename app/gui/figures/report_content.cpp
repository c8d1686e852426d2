#include "app/gui/figures/report_content.h"

#include "app/gui/figures/figure_parts.h"
#include "app/gui/figures/report_tables.h"
#include "core/angle/comparison.h"

#include <algorithm>
#include <utility>

namespace straightedge::gui {

namespace {

/// Numbers figures and tables as they are added.
class ReportWriter {
public:
  explicit ReportWriter(ReportContent& content) : m_content(content) {}

  void heading(const QString& text) { m_content.blocks.append(ReportHeading{text}); }
  void paragraph(const QString& text, ReportParagraph::Tone tone = ReportParagraph::Tone::Plain) {
    m_content.blocks.append(ReportParagraph{text, tone});
  }
  void facts(ReportTable table) {
    table.caption.clear();
    m_content.blocks.append(std::move(table));
  }
  void table(ReportTable table) {
    table.caption = QStringLiteral("Table %1. %2.").arg(++m_tables).arg(table.caption);
    m_content.blocks.append(std::move(table));
  }
  void figures(const QList<NamedFigure>& all, FigureTopic topic) {
    for (const NamedFigure& figure : all) {
      if (figure.topic != topic) {
        continue;
      }
      ReportFigure block{QStringLiteral("Figure %1. %2").arg(++m_figures).arg(figure.caption), figure.make()};
      if (!block.spec.note.isEmpty()) {
        block.caption += QLatin1Char(' ') + block.spec.note + QLatin1Char('.');
      }
      block.spec.title.clear();
      block.spec.note.clear();
      m_content.blocks.append(std::move(block));
    }
  }
  /// A heading only where figures follow.
  void section(const QString& text, const QList<NamedFigure>& all, FigureTopic topic) {
    if (std::ranges::any_of(all, [topic](const NamedFigure& figure) { return figure.topic == topic; })) {
      heading(text);
      figures(all, topic);
    }
  }

private:
  ReportContent& m_content;
  int m_figures = 0;
  int m_tables = 0;
};

void addSummary(ReportWriter& report, const AngleResults& results) {
  const angle::AngleCalibration& calibration = results.calibration;
  report.heading(QStringLiteral("Result"));
  if (results.verification) {
    report.paragraph(verdictSentence(*results.verification) + QLatin1Char(' ') +
                         fromText(results.verification->decisionRule),
                     results.verification->met ? ReportParagraph::Tone::Good : ReportParagraph::Tone::Bad);
  } else {
    report.paragraph(QStringLiteral("No fresh sweep was verified: the errors below are those of the data the models "
                                    "were made from."));
  }
  report.table(modelsTable(calibration));
  for (const angle::Warning& warning : calibration.warnings) {
    report.paragraph(fromText(warning.text), ReportParagraph::Tone::Warning);
  }
}

void addComparison(ReportWriter& report, const AngleResults& results, const QList<NamedFigure>& figures) {
  if (!results.comparison || results.comparison->rows.empty()) {
    return;
  }
  report.heading(QStringLiteral("Comparison of the methods"));
  if (results.targetErrorDeg) {
    report.paragraph(fromText(angle::recommendForTarget(*results.comparison, *results.targetErrorDeg).sentence));
  }
  if (results.budgetEntries) {
    report.paragraph(fromText(angle::recommendForBudget(*results.comparison, *results.budgetEntries).sentence));
  }
  report.figures(figures, FigureTopic::Comparison);
  report.table(comparisonTable(*results.comparison));
}

} // namespace

ReportContent angleReport(const std::shared_ptr<const AngleResults>& shared) {
  const AngleResults& results = *shared;
  const angle::AngleCalibration& calibration = results.calibration;
  ReportContent content;
  content.title = QStringLiteral("Angle calibration");
  QStringList device;
  for (const std::string& part : {calibration.traceability.deviceModel, calibration.traceability.deviceSerial}) {
    if (!part.empty()) {
      device << fromText(part);
    }
  }
  content.subtitle = device.isEmpty() ? fromText(calibration.source.file) : device.join(QStringLiteral(" · "));
  content.software = fromText(calibration.software);
  content.created = fromText(calibration.created);

  const QList<NamedFigure> figures = angleFigures(shared);
  ReportWriter report(content);
  report.facts(traceabilityTable(calibration));
  addSummary(report, results);
  report.heading(QStringLiteral("Recorded data"));
  report.facts(dataTable(results));
  report.figures(figures, FigureTopic::Data);
  report.section(QStringLiteral("Correction curve"), figures, FigureTopic::Curve);
  report.section(QStringLiteral("Models"), figures, FigureTopic::Models);
  addComparison(report, results, figures);
  if (!calibration.uncertainty.empty()) {
    report.heading(QStringLiteral("Uncertainty"));
    for (const angle::UncertaintyBudget& budget : calibration.uncertainty) {
      report.table(uncertaintyTable(budget));
    }
  }
  if (results.verification) {
    report.heading(QStringLiteral("Verification"));
    report.table(verificationTable(*results.verification));
    report.figures(figures, FigureTopic::Verification);
  }
  report.heading(QStringLiteral("Coefficients"));
  report.paragraph(calibration.direction == angle::SensorDirection::Decreasing
                       ? QStringLiteral("The sensor runs backwards: x = 360° − reading, corrected angle = x + "
                                        "correction(x), wrapped to one turn.")
                       : QStringLiteral("Corrected angle = reading + correction(reading), wrapped to one turn."));
  for (const angle::Model& model : calibration.models) {
    report.table(coefficientsTable(model));
  }
  return content;
}

} // namespace straightedge::gui
