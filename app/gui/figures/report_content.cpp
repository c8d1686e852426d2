#include "app/gui/figures/report_content.h"

#include "app/gui/figures/figure_parts.h"
#include "app/gui/figures/report_tables.h"
#include "app/gui/figures/report_writer.h"
#include "core/angle/comparison.h"

namespace straightedge::gui {

namespace {

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
  content.subtitle = reportSubtitle(calibration.traceability, calibration.source.file);
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
