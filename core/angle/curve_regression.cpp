#include "core/angle/curve_regression.h"

#include "core/angle/angles.h"
#include "core/angle/encoder_groups.h"
#include "core/numerics/statistics.h"
#include "core/numerics/trigonometric_fit.h"

#include <algorithm>

namespace straightedge::angle {

CorrectionCurve regressCurve(const AlignedSweep& aligned, int resolvableHarmonics) {
  constexpr std::size_t mostGroups = 2048;
  const EncoderGroups groups = groupEncoderAngles(aligned.encoderDeg, mostGroups);
  // One group has to be foretold by the others: they must outnumber the coefficients.
  const int most = std::min(resolvableHarmonics, std::max(0, (static_cast<int>(groups.count) - 2) / 2));
  const auto fit =
      numerics::fitTrigonometric(aligned.readingDeg, aligned.correctionDeg, groups.ofPoint, groups.count, most);

  CorrectionCurve curve;
  curve.method = CurveMethod::Regress;
  curve.trigonometric = {fit.offset, fit.cosine, fit.sine};
  curve.leaveOneOutRmsDeg = numerics::rootMeanSquare(fit.leftOutResiduals);
  curve.leaveOneOutMaxDeg = numerics::largestMagnitude(fit.leftOutResiduals);
  curve.residualSigmaDeg = fit.residualSigma;
  curve.harmonics = fit.harmonics;
  curve.crossValidationRmsDeg = fit.leftOutRms;
  return curve;
}

} // namespace straightedge::angle
