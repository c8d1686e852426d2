// Recorded data as plots: Capture and Review show them, the report prints them. Degrees throughout.
#pragma once

#include "app/gui/plots/plot_spec.h"
#include "core/angle/alignment.h"
#include "core/angle/curve.h"
#include "core/angle/sweep.h"

#include <cstdint>
#include <vector>

namespace straightedge::gui {

/// A plot whose points stand for rows of a sweep, so that a click can find the row.
struct RowFigure {
  PlotSpec spec;
  std::vector<std::vector<std::size_t>> rows; ///< rows[series][index]; empty for a series that is only a line
};

/// Sensor angle over encoder angle as read (raw data). Points per direction; a thin line joins neighbours and breaks
/// where the sensor wraps. Switched-off rows are emphasised.
RowFigure sensorOverEncoderFigure(const angle::Sweep& sweep);

/// Sensor angle over encoder angle with the wrap-around removed: continuous, one turn.
RowFigure unwrappedFigure(const angle::AlignedSweep& aligned);

enum class ErrorAxis : std::uint8_t { Encoder, Sensor };
/// The mounting angle is a constant part of the error; without it the shape is easier to see.
enum class ConstantPart : std::uint8_t { Kept, Removed };

/// Angle error sensor − encoder (of 360° − sensor for a decreasing sensor), continuous over the turn, over the encoder
/// or sensor angle. The largest |error| stands in the note.
RowFigure errorFigure(const angle::Sweep& sweep, angle::SensorDirection direction, ErrorAxis axis, ConstantPart part);

/// The two figures above without data, for live capture: series 0 takes the points.
PlotSpec liveSensorFigure();
PlotSpec liveErrorFigure();

/// Rising and falling passes about their common mean, and half their difference; both directions are needed.
PlotSpec hysteresisFigure(const angle::Repeatability& passes);

/// Polar ring: planned encoder angles, those done, gaps in coverage as arcs.
PlotSpec coverageRingFigure(const std::vector<double>& plannedDeg, const std::vector<double>& doneDeg,
                            const std::vector<angle::CoverageGap>& gaps);

/// Deviations of readings from the mean at the same angle, direction and turn, as a histogram; where each angle was
/// read once, deviations of the points from a regressed curve; otherwise an empty figure that says why.
PlotSpec noiseHistogramFigure(const angle::AlignedSweep& aligned, const angle::CorrectionCurve* curve = nullptr);

} // namespace straightedge::gui
