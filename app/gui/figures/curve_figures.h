// The correction curve as plots: projection onto the sensor's grid, the curve itself, its harmonics. Degrees.
#pragma once

#include "app/gui/plots/plot_spec.h"
#include "core/angle/calibration.h"

#include <vector>

namespace straightedge::gui {

/// Encoder angle over the regular grid of sensor angles, with the recorded points it was found from.
PlotSpec projectionFigure(const angle::AlignedSweep& aligned, const angle::CorrectionCurve& curve);

/// Correction over sensor angle with the recorded points.
PlotSpec correctionCurveFigure(const angle::AlignedSweep& aligned, const angle::CorrectionCurve& curve);

/// The curve repeated over `turns`, with its `count` largest harmonics each drawn about the mean.
PlotSpec repeatedCurveFigure(const angle::CorrectionCurve& curve, angle::SensorDirection direction, int turns = 3,
                             int count = 3);

/// Harmonics 1 to `count` of the curve, as many as its points resolve, in order.
std::vector<angle::HarmonicTerm> curveHarmonics(const angle::CorrectionCurve& curve, int count = 16);
/// Amplitudes (logarithmic axis) and phases as bars.
PlotSpec harmonicAmplitudesFigure(const std::vector<angle::HarmonicTerm>& harmonics);
PlotSpec harmonicPhasesFigure(const std::vector<angle::HarmonicTerm>& harmonics);

} // namespace straightedge::gui
