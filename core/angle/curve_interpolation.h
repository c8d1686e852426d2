// Correction curve that passes through every point: a periodic cubic spline over the reading.
#pragma once

#include "core/angle/curve.h"

namespace straightedge::angle {

/// `aligned` must not repeat (asserted). Leave-one-out is exact: the spline through all other points, for every point.
CorrectionCurve interpolateCurve(const AlignedSweep& aligned);

} // namespace straightedge::angle
