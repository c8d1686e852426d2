// Correction curve that runs between the points: periodic least squares on the reading, for data that repeat, are noisy
// or step back.
#pragma once

#include "core/angle/curve.h"

namespace straightedge::angle {

/// Harmonics by leave-one-out cross-validation: all rows at one encoder angle are left out together. Of more than 2048
/// angles, all rows within 360/2048° are: dense rows would otherwise foretell their neighbours' noise.
CorrectionCurve regressCurve(const AlignedSweep& aligned, int resolvableHarmonics);

} // namespace straightedge::angle
