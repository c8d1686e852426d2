// A fresh sweep before and after correction, against the limit. Degrees.
#pragma once

#include "app/gui/plots/plot_spec.h"
#include "core/angle/verification.h"

namespace straightedge::gui {

/// Error over encoder angle before (dimmed, right axis where it is more than five times as large) and after correction,
/// with the limit on both sides.
PlotSpec beforeAfterFigure(const angle::VerificationReport& report);

/// Only the corrected error, with the limit and, inside it, where the limit is kept beyond doubt.
PlotSpec correctedErrorFigure(const angle::VerificationReport& report);

} // namespace straightedge::gui
