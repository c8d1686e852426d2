// Tables that the report prints and the window copies to the clipboard.
#pragma once

#include "app/gui/figures/report_content.h"

namespace straightedge::gui {

/// Storage and errors of every model; the expanded uncertainty where it is known.
ReportTable modelsTable(const angle::AngleCalibration& calibration);
/// Coefficients of one model; beyond `limit` values the table says how many there are in all.
ReportTable coefficientsTable(const angle::Model& model, int limit = 256);
ReportTable uncertaintyTable(const angle::UncertaintyBudget& budget);
/// The comparison at a choice of sizes: 1, 2, 4, … of every method.
ReportTable comparisonTable(const angle::Comparison& comparison);
ReportTable verificationTable(const angle::VerificationReport& report);
/// What both kinds of calibration know about where they come from.
struct ReportOrigin {
  Traceability traceability;
  SourceRecord source;
  std::string software, created;
  QString referenceUncertainty; ///< for people, with its unit
};
/// Who, what, with what and when.
ReportTable traceabilityTable(const ReportOrigin& origin);
ReportTable traceabilityTable(const angle::AngleCalibration& calibration);
/// How good the data are: points, coverage, noise, repeatability, hysteresis, curve.
ReportTable dataTable(const AngleResults& results);

/// "Passed: …" or "Failed: …" with figures, and whether uncertainty leaves a doubt.
QString verdictSentence(const angle::VerificationReport& report);

/// Tab-separated text with a header line, for spreadsheets.
QString tableAsText(const ReportTable& table);

} // namespace straightedge::gui
