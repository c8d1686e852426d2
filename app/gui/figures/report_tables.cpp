#include "app/gui/figures/report_tables.h"

#include "app/gui/figures/figure_parts.h"
#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>

namespace straightedge::gui {

namespace {

QString number(double value, int digits = 4) { return fromText(formatForPeople(value, digits)); }

QString given(const std::string& text) { return text.empty() ? QStringLiteral("not stated") : fromText(text); }

bool isPowerOfTwo(int value) { return value > 0 && (value & (value - 1)) == 0; }

QString optionalDegrees(const std::optional<double>& value) {
  return value ? degrees(*value, 3) : QStringLiteral("not known from this sweep");
}

} // namespace

ReportTable modelsTable(const angle::AngleCalibration& calibration) {
  ReportTable table;
  table.caption = QStringLiteral("Models: storage and errors in degrees");
  table.header = {QStringLiteral("Model"),      QStringLiteral("Entries"),   QStringLiteral("Bytes"),
                  QStringLiteral("Max curve"),  QStringLiteral("Rms curve"), QStringLiteral("Max points"),
                  QStringLiteral("Rms points"), QStringLiteral("U (95 %)")};
  for (const angle::Model& model : calibration.models) {
    const std::string name = model.name.text();
    const auto budget = std::ranges::find(calibration.uncertainty, name, &angle::UncertaintyBudget::model);
    table.rows.append({fromText(name), QString::number(model.name.storageEntries()),
                       QString::number(model.name.storageBytes()), number(model.errors.maxCurveDeg),
                       number(model.errors.rmsCurveDeg), number(model.errors.maxPointsDeg),
                       number(model.errors.rmsPointsDeg),
                       budget == calibration.uncertainty.end() ? QStringLiteral("–") : number(budget->expandedDeg)});
  }
  return table;
}

namespace {

void addValues(ReportTable& table, const Eigen::VectorXd& values, int limit) {
  constexpr int columns = 3; // as many as fit the width of a page
  const int shown = std::min(limit, static_cast<int>(values.size()));
  const int rows = (shown + columns - 1) / columns;
  for (int c = 0; c < columns; ++c) {
    table.header << QStringLiteral("Angle (°)") << QStringLiteral("Correction (°)");
  }
  for (int r = 0; r < rows; ++r) {
    QStringList cells;
    for (int c = 0; c < columns; ++c) {
      const int k = c * rows + r;
      cells << (k < shown ? number(k * 360.0 / static_cast<double>(values.size()), 7) : QString())
            << (k < shown ? number(values[k], 7) : QString());
    }
    table.rows.append(cells);
  }
  table.firstNumericColumn = 0;
  if (shown < values.size()) {
    table.caption +=
        QStringLiteral("; the first %1 of %2 values, all of them are in the table file").arg(shown).arg(values.size());
  }
}

} // namespace

ReportTable coefficientsTable(const angle::Model& model, int limit) {
  ReportTable table;
  table.caption = QStringLiteral("Coefficients of %1").arg(modelNameText(model.name));
  if (const auto* harmonic = std::get_if<angle::HarmonicModel>(&model.body)) {
    table.header = {QStringLiteral("Harmonic"), QStringLiteral("Amplitude (°)"), QStringLiteral("Phase (rad)")};
    table.rows.append({QStringLiteral("offset"), number(harmonic->offsetDeg, 9), {}});
    for (const angle::HarmonicTerm& term : harmonic->terms) {
      table.rows.append({QString::number(term.order), number(term.amplitudeDeg, 9), number(term.phaseRad, 9)});
    }
  } else if (const auto* linear = std::get_if<angle::LinearModel>(&model.body)) {
    addValues(table, linear->valuesDeg, limit);
  } else if (const auto* lookup = std::get_if<angle::LookupTableModel>(&model.body)) {
    table.caption += QStringLiteral(" by the first angle of each bin");
    addValues(table, lookup->valuesDeg, limit);
  }
  return table;
}

ReportTable uncertaintyTable(const angle::UncertaintyBudget& budget) {
  ReportTable table;
  table.caption = QStringLiteral("Uncertainty of an angle corrected with %1").arg(fromText(budget.model));
  table.header = {QStringLiteral("Contribution"), QStringLiteral("Standard (°)"), QStringLiteral("Basis")};
  table.lastNumericColumn = 1;
  for (const angle::UncertaintyContribution& part : budget.contributions) {
    table.rows.append({fromText(part.name), number(part.standardDeg, 3), fromText(part.basis)});
  }
  table.rows.append({QStringLiteral("combined"), number(budget.combinedDeg, 3), QStringLiteral("root sum of squares")});
  table.rows.append({QStringLiteral("expanded, 95 %"), number(budget.expandedDeg, 3),
                     QStringLiteral("coverage factor %1").arg(number(budget.coverageFactor, 3))});
  return table;
}

ReportTable comparisonTable(const angle::Comparison& comparison) {
  ReportTable table;
  table.caption = QStringLiteral("Residual error and storage at a choice of sizes, in degrees");
  table.header = {QStringLiteral("Method"), QStringLiteral("Size"),    QStringLiteral("Entries"),
                  QStringLiteral("Bytes"),  QStringLiteral("Maximum"), QStringLiteral("Rms")};
  for (const angle::ComparisonRow& row : comparison.rows) {
    if (isPowerOfTwo(row.name.size)) {
      table.rows.append({methodTitle(row.name.kind, row.name.method), QString::number(row.name.size),
                         QString::number(row.storageEntries), QString::number(row.bytes),
                         number(row.maxErrorFineDeg.value_or(row.maxErrorDeg), 3), number(row.rmsErrorDeg, 3)});
    }
  }
  return table;
}

ReportTable verificationTable(const angle::VerificationReport& report) {
  ReportTable table;
  table.caption =
      QStringLiteral("Verification of %1 with a limit of %2").arg(fromText(report.model), degrees(report.limitDeg));
  table.header = {QStringLiteral("Error (°)"), QStringLiteral("Before"), QStringLiteral("After")};
  table.rows.append({QStringLiteral("Maximum"), number(report.maxErrorBeforeDeg), number(report.maxErrorDeg)});
  table.rows.append({QStringLiteral("Root mean square"), number(report.rmsErrorBeforeDeg), number(report.rmsErrorDeg)});
  table.rows.append({QStringLiteral("Points"), QString::number(report.points), QString::number(report.points)});
  return table;
}

ReportTable traceabilityTable(const angle::AngleCalibration& calibration) {
  return traceabilityTable({calibration.traceability, calibration.source, calibration.software, calibration.created,
                            degrees(calibration.traceability.reference.uncertainty)});
}

ReportTable traceabilityTable(const ReportOrigin& origin) {
  const Traceability& trace = origin.traceability;
  ReportTable table;
  table.firstNumericColumn = 99;
  table.rows = {{QStringLiteral("Device"), given(trace.deviceModel)},
                {QStringLiteral("Serial number"), given(trace.deviceSerial)},
                {QStringLiteral("Operator"), given(trace.operatorName)},
                {QStringLiteral("Ambient temperature"),
                 trace.ambientC ? number(*trace.ambientC) + QStringLiteral(" °C") : QStringLiteral("not stated")},
                {QStringLiteral("Reference"), given(trace.reference.model)},
                {QStringLiteral("Reference serial"), given(trace.reference.serial)},
                {QStringLiteral("Certificate"), given(trace.reference.certificate)},
                {QStringLiteral("Reference due"), given(trace.reference.due)},
                {QStringLiteral("Reference uncertainty (k = 2)"),
                 trace.reference.uncertainty > 0.0 ? origin.referenceUncertainty : QStringLiteral("not stated")},
                {QStringLiteral("Data"), given(origin.source.file)},
                {QStringLiteral("SHA-256 of the data"), given(origin.source.sha256)},
                {QStringLiteral("Software"), given(origin.software)},
                {QStringLiteral("Created"), given(origin.created)}};
  return table;
}

ReportTable dataTable(const AngleResults& results) {
  const angle::AngleCalibration& calibration = results.calibration;
  ReportTable table;
  table.firstNumericColumn = 99;
  table.rows.append({QStringLiteral("Points"), QString::number(calibration.source.points)});
  if (results.run) {
    const angle::AlignedSweep& aligned = results.run->aligned;
    table.rows.append({QStringLiteral("Distinct angles"), QString::number(aligned.distinctAngles)});
    table.rows.append(
        {QStringLiteral("Distance between points"),
         QStringLiteral("%1 median, %2 at most").arg(degrees(aligned.medianGapDeg), degrees(aligned.largestGapDeg))});
  }
  table.rows.append({QStringLiteral("Sensor direction"), calibration.direction == angle::SensorDirection::Decreasing
                                                             ? QStringLiteral("decreasing: 360° − reading is corrected")
                                                             : QStringLiteral("increasing")});
  table.rows.append({QStringLiteral("Turns"), QString::number(calibration.passes.turns)});
  table.rows.append({QStringLiteral("Noise"), optionalDegrees(calibration.passes.noiseDeg)});
  table.rows.append({QStringLiteral("Repeatability"), optionalDegrees(calibration.passes.repeatabilityDeg)});
  table.rows.append(
      {QStringLiteral("Hysteresis, half difference"), optionalDegrees(calibration.passes.hysteresisMaxDeg)});
  table.rows.append(
      {QStringLiteral("Curve"), calibration.curveMethod == angle::CurveMethod::Regress
                                    ? QStringLiteral("regression with %1 harmonics").arg(calibration.curveHarmonics)
                                    : QStringLiteral("periodic spline through the points")});
  table.rows.append({QStringLiteral("Leave-one-out error"),
                     QStringLiteral("%1 rms, %2 at most")
                         .arg(degrees(calibration.leaveOneOutRmsDeg, 3), degrees(calibration.leaveOneOutMaxDeg, 3))});
  return table;
}

QString verdictSentence(const angle::VerificationReport& report) {
  QString sentence =
      QStringLiteral("%1: largest error %2 %3 the limit of %4")
          .arg(report.met ? QStringLiteral("Passed") : QStringLiteral("Failed"), degrees(report.maxErrorDeg),
               report.met ? QStringLiteral("is within") : QStringLiteral("exceeds"), degrees(report.limitDeg));
  if (report.verdict == angle::Verdict::PassWithinUncertainty ||
      report.verdict == angle::Verdict::FailWithinUncertainty) {
    sentence += QStringLiteral(", closer to it than the expanded uncertainty of %1")
                    .arg(degrees(report.expandedUncertaintyDeg, 3));
  }
  return sentence + QLatin1Char('.');
}

QString tableAsText(const ReportTable& table) {
  QString text;
  if (!table.header.isEmpty()) {
    text += table.header.join(QLatin1Char('\t')) + QLatin1Char('\n');
  }
  for (const QStringList& row : table.rows) {
    text += row.join(QLatin1Char('\t')) + QLatin1Char('\n');
  }
  return text;
}

} // namespace straightedge::gui
