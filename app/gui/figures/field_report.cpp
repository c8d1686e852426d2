#include "app/gui/figures/field_figure_parts.h"
#include "app/gui/figures/field_report_tables.h"
#include "app/gui/figures/field_words.h"
#include "app/gui/figures/figure_parts.h"
#include "app/gui/figures/report_tables.h"
#include "app/gui/figures/report_writer.h"
#include "core/field/block_names.h"
#include "core/field/names.h"

#include <algorithm>

namespace straightedge::gui {

namespace {

const char* const chainFormula =
    "With R the resistance of the PT100 in ohms, E the temperature of the electronics less the reference temperature, "
    "and polynomials in ascending powers: T = slope·R + intercept; V1 = nonlinearity(raw); V2 = V1 − (offset[0] + "
    "offset[1]·T); V3 = V2 − (K(V2)·T + C(V2)); V4 = V3 − (electronics[0] + electronics[1]·E); V5 = V4 − (es[0] + "
    "es[1]·V4)·E, es the electronics' sensitivity; B = S⁻¹·(V5 of x, y, z).";

/// Peaks after correction, axis by axis.
QString peaksSentence(const field::FieldCalibration& calibration) {
  QStringList peaks;
  for (const field::VerificationRow& row : calibration.verification) {
    if (row.state == field::VerifiedState::Calibrated) {
      peaks << axisLetter(row.axis) + QLatin1Char(' ') + percentText(row.ofFullScale.peak);
    }
  }
  return QStringLiteral("No fresh campaign was verified against a limit. Over the campaign's own verification rows the "
                        "largest error after correction is, of full scale: ") +
         peaks.join(QStringLiteral(", ")) + QLatin1Char('.');
}

void addFieldSummary(ReportWriter& report, const FieldResults& results) {
  const field::FieldCalibration& calibration = results.calibration;
  report.heading(QStringLiteral("Result"));
  if (results.verification) {
    report.paragraph(fieldVerdictSentence(*results.verification) +
                         (results.verificationIsFresh
                              ? QStringLiteral(" Measured with a fresh campaign.")
                              : QStringLiteral(" Measured with the calibration campaign's own verification rows.")),
                     results.verification->met ? ReportParagraph::Tone::Good : ReportParagraph::Tone::Bad);
  } else if (calibration.verification.empty()) {
    report.paragraph(QStringLiteral("The campaign has no verification rows: how good the correction is was not "
                                    "measured."),
                     ReportParagraph::Tone::Warning);
  } else {
    report.paragraph(peaksSentence(calibration));
  }
  report.paragraph(calibration.method == field::FitMethod::Joint
                       ? QStringLiteral("All blocks were fitted together. ") + fromText(calibration.jointHow)
                       : QStringLiteral("The blocks were fitted one after the other, each on what the ones before "
                                        "leave."));
  report.table(blocksTable(calibration));
  for (const field::FieldWarning& warning : calibration.warnings) {
    report.paragraph(fromText(warning.text), ReportParagraph::Tone::Warning);
  }
}

void addNonlinearitySection(ReportWriter& report, const field::FieldCalibration& calibration,
                            const QList<NamedFigure>& figures) {
  if (calibration.orders.empty()) {
    return;
  }
  report.heading(QStringLiteral("Nonlinearity"));
  for (const field::Axis axis : field::allAxes) {
    if (const std::string& text = calibration.orderExplanation.at(field::indexOf(axis)); !text.empty()) {
      report.paragraph(QStringLiteral("Axis %1: ").arg(axisLetter(axis)) + fromText(text));
    }
  }
  report.table(ordersTable(calibration));
  report.figures(figures, FigureTopic::Nonlinearity);
}

void addProbeSection(ReportWriter& report, const field::FieldCalibration& calibration,
                     const QList<NamedFigure>& figures) {
  if (!calibration.chain.pt100) {
    return;
  }
  report.heading(QStringLiteral("Probe temperature"));
  ReportTable facts;
  facts.firstNumericColumn = 99;
  facts.rows.append(
      {QStringLiteral("Slope"), peopleNumber(calibration.chain.pt100->slopeCPerOhm, 9) + QStringLiteral(" °C/Ω")});
  facts.rows.append({QStringLiteral("Intercept, minus the reference temperature"),
                     peopleNumber(calibration.chain.pt100->interceptC, 9) + QStringLiteral(" °C")});
  if (calibration.probe) {
    const field::ProbeQuality& probe = *calibration.probe;
    facts.rows.append(
        {QStringLiteral("Standard uncertainty"), peopleNumber(probe.standardUncertaintyC, 2) + QStringLiteral(" °C")});
    facts.rows.append({QStringLiteral("Loop between heating and cooling"),
                       probe.hysteresisC ? peopleNumber(*probe.hysteresisC, 2) + QStringLiteral(" °C wide")
                                         : QStringLiteral("not known: one direction only")});
    facts.rows.append({QStringLiteral("Lag"), fromText(probe.lagText)});
  }
  report.facts(facts);
  report.figures(figures, FigureTopic::ProbeTemperature);
}

void addVerificationSection(ReportWriter& report, const FieldResults& results, const QList<NamedFigure>& figures) {
  const field::FieldCalibration& calibration = results.calibration;
  if (calibration.verification.empty() && !results.verification) {
    return;
  }
  report.heading(QStringLiteral("Verification"));
  if (!calibration.verification.empty()) {
    report.table(fieldVerificationTable(calibration.verification, field::PercentOf::FullScale));
    if (std::ranges::any_of(calibration.verification,
                            [](const field::VerificationRow& row) { return row.ofReading.has_value(); })) {
      report.table(fieldVerificationTable(calibration.verification, field::PercentOf::Reading));
    }
  }
  if (results.verification && results.verificationIsFresh) {
    report.paragraph(QStringLiteral("The fresh campaign:"));
    report.table(fieldVerificationTable(results.verification->verification.rows, results.verification->of));
  }
  if (!calibration.stepwiseVerification.empty()) {
    report.paragraph(QStringLiteral("The fit block after block, from which the joint fit started, had left:"));
    report.table(fieldVerificationTable(calibration.stepwiseVerification, field::PercentOf::FullScale));
  }
  report.figures(figures, FigureTopic::Verification);
}

void addCoefficientSection(ReportWriter& report, const field::FieldCalibration& calibration) {
  report.heading(QStringLiteral("Coefficients"));
  report.paragraph(QString::fromUtf8(chainFormula));
  report.table(chainTable(calibration.chain));
  if (calibration.chain.axisMatrix) {
    report.table(axisMatrixTable(*calibration.chain.axisMatrix));
  }
}

/// How every block was made, in sentences.
void addHowMade(ReportWriter& report, const field::FieldCalibration& calibration) {
  ReportTable facts;
  facts.firstNumericColumn = 99;
  for (const field::BlockSummary& summary : calibration.blocks) {
    if (!summary.how.empty()) {
      facts.rows.append(
          {blockTitle(summary.block) + (summary.axis ? QStringLiteral(", ") + axisLetter(*summary.axis) : QString()),
           fromText(summary.how)});
    }
  }
  if (!facts.rows.isEmpty()) {
    report.heading(QStringLiteral("How the blocks were made"));
    report.facts(facts);
  }
}

} // namespace

ReportContent fieldReport(const std::shared_ptr<const FieldResults>& shared, ScenePictures* pictures) {
  const FieldResults& results = *shared;
  const field::FieldCalibration& calibration = results.calibration;
  ReportContent content;
  content.title = QStringLiteral("Field calibration");
  content.subtitle = reportSubtitle(calibration.traceability, calibration.source.file);
  content.software = fromText(calibration.software);
  content.created = fromText(calibration.created);

  const QList<NamedFigure> figures = fieldFigures(shared);
  ReportWriter report(content, pictures);
  ReportTable origin =
      traceabilityTable({calibration.traceability, calibration.source, calibration.software, calibration.created,
                         microteslaText(calibration.traceability.reference.uncertainty)});
  origin.rows.append({QStringLiteral("Full scale"), teslaText(calibration.chain.fullScaleT)});
  origin.rows.append({QStringLiteral("Reference temperature"),
                      peopleNumber(calibration.chain.referenceTemperatureC) + QStringLiteral(" °C")});
  report.facts(origin);
  addFieldSummary(report, results);
  if (results.run) {
    report.heading(QStringLiteral("Recorded data"));
    report.table(campaignTable(results));
    report.figures(figures, FigureTopic::Data);
  }
  addNonlinearitySection(report, calibration, figures);
  addProbeSection(report, calibration, figures);
  report.section(QStringLiteral("Offset over probe temperature"), figures, FigureTopic::Offset);
  report.section(QStringLiteral("Sensitivity over probe temperature"), figures, FigureTopic::Sensitivity);
  report.section(QStringLiteral("Electronics temperature"), figures, FigureTopic::Electronics);
  if (calibration.chain.axisMatrix) {
    report.heading(QStringLiteral("Directions of the axes"));
    report.table(axisAnglesTable(*calibration.chain.axisMatrix));
    report.figures(figures, FigureTopic::AxisMatrix);
  }
  addVerificationSection(report, results, figures);
  if (calibration.uncertainty) {
    report.heading(QStringLiteral("Uncertainty"));
    report.table(fieldUncertaintyTable(*calibration.uncertainty));
    report.figures(figures, FigureTopic::Uncertainty);
  }
  if (results.comparison && !results.comparison->choices.empty()) {
    report.heading(QStringLiteral("Storage against error"));
    report.figures(figures, FigureTopic::Comparison);
    report.table(storageTable(*results.comparison));
  }
  addCoefficientSection(report, calibration);
  addHowMade(report, calibration);
  return content;
}

} // namespace straightedge::gui
