#include "core/angle/uncertainty.h"

#include "core/angle/messages.h"
#include "core/angle/sensor_resolution.h"
#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace straightedge::angle {

namespace {

double squared(double value) { return value * value; }

/// Scatter of single readings that the sweep shows, by whatever means it has.
double readingScatter(const AlignedSweep& aligned, const CorrectionCurve& curve) {
  if (aligned.passes.noiseDeg) {
    return *aligned.passes.noiseDeg;
  }
  return curve.residualSigmaDeg.value_or(curve.leaveOneOutRmsDeg);
}

UncertaintyContribution noise(const AlignedSweep& aligned, const CorrectionCurve& curve) {
  if (aligned.passes.noiseDeg) {
    return {"noise", *aligned.passes.noiseDeg,
            "type A: standard deviation of single readings at one angle, direction and turn, pooled over the sweep"};
  }
  if (curve.residualSigmaDeg) {
    return {"noise", *curve.residualSigmaDeg,
            "type A: standard deviation of the points about the regression curve; no angle was read twice in one pass, "
            "so repeatability, hysteresis and what the curve leaves out are in it"};
  }
  return {"noise", 0.0, "not seen apart: every angle was read once; it is in the correction curve's figure"};
}

UncertaintyContribution repeatability(const AlignedSweep& aligned) {
  if (aligned.passes.repeatabilityDeg) {
    return {"repeatability", *aligned.passes.repeatabilityDeg,
            aligned.passes.noiseDeg
                ? "type A: standard deviation between turns of the means at one angle and direction, noise taken off"
                : "type A: standard deviation between turns at one angle and direction; noise is in it"};
  }
  return {"repeatability", 0.0, "not seen: no angle was visited in more than one turn"};
}

UncertaintyContribution hysteresis(const AlignedSweep& aligned) {
  if (aligned.passes.hysteresisMaxDeg) {
    return {"hysteresis", *aligned.passes.hysteresisMaxDeg / std::numbers::sqrt3,
            "type B: rectangular, half width " + degreesText(*aligned.passes.hysteresisMaxDeg) +
                " (largest half difference between the directions), divided by √3"};
  }
  return {"hysteresis", 0.0, "not seen: no angle was visited in both directions"};
}

UncertaintyContribution reference(const UncertaintyInputs& inputs) {
  if (inputs.referenceExpandedDeg > 0.0) {
    return {"reference", inputs.referenceExpandedDeg / 2.0,
            "type B: stated expanded uncertainty " + degreesText(inputs.referenceExpandedDeg) +
                ", normal, divided by 2"};
  }
  return {"reference", 0.0, "not counted: no uncertainty of the reference was stated"};
}

UncertaintyContribution quantisation(const AlignedSweep& aligned, const CorrectionCurve& curve,
                                     const UncertaintyInputs& inputs) {
  const bool given = inputs.sensorResolutionDeg > 0.0;
  const double step = given ? inputs.sensorResolutionDeg : estimateResolutionDeg(aligned.readingDeg);
  if (step <= 0.0) {
    return {"quantisation", 0.0, "not seen: the readings fall on no usual step"};
  }
  const std::string origin = given ? " (given)" : " (estimated from the readings)";
  // Readings that scatter over several steps are rounded at random: the measured scatter holds that rounding already.
  if (readingScatter(aligned, curve) >= 0.5 * step) {
    return {"quantisation", 0.0,
            "step " + degreesText(step) + origin + ": already in the measured scatter of the readings"};
  }
  return {"quantisation", step / std::sqrt(12.0),
          "type B: rectangular, half of one step of " + degreesText(step) + origin + ", divided by √3"};
}

UncertaintyContribution correctionCurve(const AlignedSweep& aligned, const CorrectionCurve& curve) {
  if (!curve.residualSigmaDeg) {
    return {"correction curve", curve.leaveOneOutRmsDeg,
            "type A: rms of how far the spline through all other points misses each point (leave-one-out); the noise "
            "of single readings is in it"};
  }
  const double points = static_cast<double>(aligned.readingDeg.size());
  // Leverages add up to the number of coefficients, so the mean variance of the curve is that share of the scatter's.
  const double fromScatter = squared(*curve.residualSigmaDeg) * (2.0 * curve.harmonics + 1.0) / points;
  if (!aligned.passes.noiseDeg) {
    return {"correction curve", std::sqrt(fromScatter),
            "type A: standard error of the regression curve, averaged over the points"};
  }
  const double explained = squared(*aligned.passes.noiseDeg) + squared(aligned.passes.repeatabilityDeg.value_or(0.0)) +
                           squared(aligned.passes.hysteresisRmsDeg.value_or(0.0));
  const double unexplained = std::max(0.0, squared(*curve.residualSigmaDeg) - explained);
  return {"correction curve", std::sqrt(fromScatter + unexplained),
          "type A: standard error of the regression curve, with the scatter about it that noise, repeatability and "
          "hysteresis do not explain"};
}

} // namespace

UncertaintyBudget uncertaintyOf(const Model& model, const AlignedSweep& aligned, const CorrectionCurve& curve,
                                const UncertaintyInputs& inputs) {
  UncertaintyBudget budget;
  budget.model = model.name.text();
  budget.contributions = {
      noise(aligned, curve),
      repeatability(aligned),
      hysteresis(aligned),
      reference(inputs),
      quantisation(aligned, curve, inputs),
      correctionCurve(aligned, curve),
      {"model residual", model.errors.rmsCurveDeg, "rms deviation of the stored model from the correction curve"},
  };
  double sum = 0.0;
  for (const UncertaintyContribution& contribution : budget.contributions) {
    sum += squared(contribution.standardDeg);
  }
  budget.combinedDeg = std::sqrt(sum);
  budget.expandedDeg = budget.coverageFactor * budget.combinedDeg;
  return budget;
}

} // namespace straightedge::angle
