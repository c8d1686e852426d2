// Verification of a field calibration as plots (Electronics 2020, 9, 151, Figures 19 to 21, Tables 2 and 3).
#pragma once

#include "app/gui/plots/plot_spec.h"
#include "core/field/verification.h"

#include <optional>
#include <vector>

namespace straightedge::gui {

/// Figure 19: error of one axis over the reference field, raw (on an axis of its own where it is more than five times
/// as large) and after the axis's chain. `limitPercent` of full scale: a line on both sides.
PlotSpec fieldBeforeAfterFigure(const field::AxisErrors& errors, double fullScaleT,
                                std::optional<double> limitPercent = {});

/// Peak of the error before and after each block, all axes, on a logarithmic scale.
PlotSpec blockPeaksFigure(const std::vector<field::VerificationRow>& rows);

} // namespace straightedge::gui
