// Sensitivity over temperature as plots (Electronics 2020, 9, 151, Figures 11 and 15 to 17, 20 and 21), of the probe
// and of the electronics.
#pragma once

#include "app/gui/plots/plot_spec.h"
#include "core/field/field_fit.h"

namespace straightedge::gui {

enum class SweptTemperature : std::uint8_t { Probe, Electronics };

/// Figures 11 and 15: error (instrument − reference, before the block) over temperature at every locked field, with
/// the line through each. Nothing to draw where the axis's block is off: then the note says so.
PlotSpec sweepErrorsFigure(const field::FieldRun& run, field::Axis axis, SweptTemperature over);

/// Figure 16: slopes of those lines over the field, all axes, with the polynomial that is kept and, of the probe, the
/// straight line beside it.
PlotSpec sweepSlopesFigure(const field::FieldRun& run, SweptTemperature over);

/// Figure 17: their intercepts at the reference temperature with the line that is kept.
PlotSpec sweepInterceptsFigure(const field::FieldRun& run);

/// Figures 20 and 21: at the smallest positive locked field, error over probe temperature before and after each block.
PlotSpec blockAfterBlockFigure(const field::FieldRun& run, field::Axis axis);

} // namespace straightedge::gui
