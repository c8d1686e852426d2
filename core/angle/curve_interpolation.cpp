#include "core/angle/curve_interpolation.h"

#include "core/numerics/periodic_spline.h"
#include "core/numerics/statistics.h"

#include <cassert>

namespace straightedge::angle {

CorrectionCurve interpolateCurve(const AlignedSweep& aligned) {
  assert(!aligned.repeats);
  CorrectionCurve curve;
  curve.method = CurveMethod::Interpolate;
  curve.spline.knotDeg = aligned.readingDeg;
  curve.spline.valueDeg = aligned.correctionDeg;
  curve.spline.secondDerivative =
      numerics::periodicSecondDerivatives(curve.spline.knotDeg, curve.spline.valueDeg, 360.0);
  const numerics::PeriodicSpline spline{curve.spline.knotDeg, curve.spline.valueDeg, curve.spline.secondDerivative,
                                        360.0};
  const Eigen::VectorXd leftOut = numerics::leaveOneOutResiduals(spline);
  curve.leaveOneOutRmsDeg = numerics::rootMeanSquare(leftOut);
  curve.leaveOneOutMaxDeg = numerics::largestMagnitude(leftOut);
  return curve;
}

} // namespace straightedge::angle
