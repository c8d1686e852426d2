#include "core/angle/verification.h"

#include "core/angle/angles.h"
#include "core/angle/messages.h"
#include "core/angle/sweep_checks.h"
#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>

namespace straightedge::angle {

namespace {

struct Spread {
  double max = 0.0;
  double rms = 0.0;
};

Spread spreadOf(const std::vector<double>& errors) {
  Spread spread;
  for (const double error : errors) {
    spread.max = std::max(spread.max, std::abs(error));
    spread.rms += error * error;
  }
  spread.rms = std::sqrt(spread.rms / static_cast<double>(errors.size()));
  return spread;
}

double expandedUncertainty(const AngleCalibration& calibration, const std::string& model) {
  const auto budget = std::find_if(calibration.uncertainty.begin(), calibration.uncertainty.end(),
                                   [&](const UncertaintyBudget& b) { return b.model == model; });
  return budget == calibration.uncertainty.end() ? 0.0 : budget->expandedDeg;
}

/// Simple acceptance (JCGM 106:2012, 8.2): the measured value alone decides, the uncertainty says how firmly.
void decide(VerificationReport& report) {
  report.met = report.maxErrorDeg <= report.limitDeg;
  const bool known = report.expandedUncertaintyDeg > 0.0;
  const double distance = std::abs(report.maxErrorDeg - report.limitDeg);
  const bool near = known && distance < report.expandedUncertaintyDeg;
  if (report.met) {
    report.verdict = near ? Verdict::PassWithinUncertainty : Verdict::Pass;
  } else {
    report.verdict = near ? Verdict::FailWithinUncertainty : Verdict::Fail;
  }
  const std::string figures = "the largest error " + degreesText(report.maxErrorDeg) + " is " +
                              (report.met ? "within" : "above") + " the limit of " + degreesText(report.limitDeg);
  report.decisionRule =
      std::string("Simple acceptance: ") + (report.met ? "passed" : "failed") + ", because " + figures;
  if (!known) {
    report.decisionRule += "; the uncertainty of the corrected angle is not known and does not count.";
  } else if (near) {
    report.decisionRule += "; it is nearer to the limit than the expanded uncertainty (95 %) of " +
                           degreesText(report.expandedUncertaintyDeg) +
                           ", so the true error may lie on the other side.";
  } else {
    report.decisionRule +=
        ", by more than the expanded uncertainty (95 %) of " + degreesText(report.expandedUncertaintyDeg) + ".";
  }
}

} // namespace

Result<VerificationReport> verify(const AngleCalibration& calibration, const Model& model, const Sweep& fresh,
                                  double limitDeg) {
  if (!std::isfinite(limitDeg) || limitDeg <= 0.0) {
    return fail(ErrorKind::Usage, "a limit of " + formatDouble(limitDeg) + "° cannot be met",
                "give a limit above 0 in degrees");
  }
  if (auto error = refuseUnreadable(fresh)) {
    return std::unexpected(std::move(*error));
  }
  VerificationReport report;
  report.model = model.name.text();
  report.limitDeg = limitDeg;
  const bool mirrored = calibration.direction == SensorDirection::Decreasing;
  for (std::size_t row = 0; row < fresh.size(); ++row) {
    if (!fresh.isEnabled(row)) {
      continue;
    }
    const double encoder = fresh.encoderDeg[row];
    const double sensor = fresh.sensorDeg[row];
    report.encoderDeg.push_back(encoder);
    report.errorBeforeDeg.push_back(wrap180((mirrored ? 360.0 - sensor : sensor) - encoder));
    report.errorAfterDeg.push_back(wrap180(correctedDeg(model, calibration.direction, sensor) - encoder));
  }
  report.points = report.encoderDeg.size();
  if (report.points == 0) {
    return fail(ErrorKind::Input, "the sweep has no points to verify with", "record a sweep, or switch points on",
                fresh.source.file);
  }
  const Spread before = spreadOf(report.errorBeforeDeg);
  const Spread after = spreadOf(report.errorAfterDeg);
  report.maxErrorBeforeDeg = before.max;
  report.rmsErrorBeforeDeg = before.rms;
  report.maxErrorDeg = after.max;
  report.rmsErrorDeg = after.rms;
  report.expandedUncertaintyDeg = expandedUncertainty(calibration, report.model);
  decide(report);
  return report;
}

} // namespace straightedge::angle
