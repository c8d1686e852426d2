// Models against the curve and the points they stand for. Degrees.
#pragma once

#include "app/gui/plots/plot_spec.h"
#include "core/angle/calibration.h"

#include <cstdint>
#include <vector>

namespace straightedge::gui {

/// One model's correction: harmonics as a curve, segments as straight lines, table entries as steps.
PlotSeries modelSeries(const angle::Model& model, SeriesColor color);

/// The curve (where known) with all models over it. `aligned` and `curve` may be null: a file keeps only the models.
PlotSpec curveWithModelsFigure(const std::vector<angle::Model>& models, const angle::AlignedSweep* aligned,
                               const angle::CorrectionCurve* curve, angle::SensorDirection direction);

/// Model minus curve over the sensor angle.
PlotSpec residualFigure(const std::vector<angle::Model>& models, const angle::CorrectionCurve& curve,
                        angle::SensorDirection direction);

/// Error that remains at the recorded points, over the encoder angle.
PlotSpec pointResidualFigure(const std::vector<angle::Model>& models, const angle::AlignedSweep& aligned);

enum class GrowingFamily : std::uint8_t { Harmonics, Segments, TableEntries };
/// Sizes shown for a family: 1, 2, 4, 8, 16 harmonics; 8 … 64 segments; 32 … 256 entries, as far as points resolve.
std::vector<angle::ModelName> growingFamily(GrowingFamily family, const angle::CorrectionCurve& curve);
/// Error that remains at the recorded points with a growing number of harmonics, segments or entries.
PlotSpec growingFamilyFigure(GrowingFamily family, const angle::AlignedSweep& aligned,
                             const angle::CorrectionCurve& curve);

/// Curve against linear interpolation of `segments` whose values were taken on the curve, by least squares and for the
/// smallest maximum error.
PlotSpec linearMethodsFigure(const angle::CorrectionCurve& curve, int segments, angle::SensorDirection direction);

/// A lookup table drawn as steps over the curve.
PlotSpec tableStepsFigure(const angle::CorrectionCurve& curve, int entries, angle::SensorDirection direction);

} // namespace straightedge::gui
