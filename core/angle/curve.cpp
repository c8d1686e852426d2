#include "core/angle/curve.h"

#include "core/angle/angles.h"
#include "core/angle/curve_interpolation.h"
#include "core/angle/curve_regression.h"
#include "core/numerics/periodic_spline.h"
#include "core/numerics/trigonometric_fit.h"

#include <algorithm>
#include <cmath>

namespace straightedge::angle {

namespace {

constexpr int mostHarmonics = 64;

numerics::PeriodicSpline viewOf(const CorrectionCurve::Spline& spline) {
  return {spline.knotDeg, spline.valueDeg, spline.secondDerivative, 360.0};
}

/// Whole turns are taken off so that the curve's mean is the offset an engineer expects.
void bringMeanHome(CorrectionCurve& curve) {
  const double mean = curve.gridDeg.mean();
  const double turns = wrap180(mean) - mean;
  const double wholeTurns = 360.0 * std::round(turns / 360.0);
  if (wholeTurns != 0.0) {
    curve.gridDeg.array() += wholeTurns;
    curve.spline.valueDeg.array() += wholeTurns;
    curve.trigonometric.offsetDeg += wholeTurns;
  }
}

} // namespace

double CorrectionCurve::at(double readingDeg) const {
  const double reading = wrap360(readingDeg);
  return method == CurveMethod::Regress
             ? numerics::trigonometricAt(trigonometric.offsetDeg, trigonometric.cosine, trigonometric.sine, reading)
             : viewOf(spline).at(reading);
}

Eigen::VectorXd CorrectionCurve::sampled(int count) const {
  return method == CurveMethod::Regress
             ? numerics::trigonometricSampled(trigonometric.offsetDeg, trigonometric.cosine, trigonometric.sine, count)
             : viewOf(spline).sampled(count);
}

Result<CorrectionCurve> fitCurve(const AlignedSweep& aligned, const CurveOptions& options) {
  if (options.method == CurveMethod::Interpolate && aligned.repeats) {
    return fail(ErrorKind::Input, "readings repeat or step back, so no curve can pass through every point",
                "use the curve 'regress' (or 'auto'), which runs between them");
  }
  const bool regress =
      options.method == CurveMethod::Regress || (options.method == CurveMethod::Auto && aligned.repeats);
  const int resolvable = std::min(mostHarmonics, static_cast<int>(aligned.distinctAngles / 2));
  CorrectionCurve curve = regress ? regressCurve(aligned, resolvable) : interpolateCurve(aligned);
  curve.resolvableHarmonics = resolvable;
  curve.gridDeg = curve.sampled(gridSize);
  bringMeanHome(curve);
  return curve;
}

} // namespace straightedge::angle
