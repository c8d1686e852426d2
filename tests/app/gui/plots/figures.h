// Typical plots of a calibration with made-up numbers, for the gallery and the tests.
#pragma once

#include "app/gui/plots/plot_spec.h"

namespace straightedge::gui::figures {

PlotSpec errorOverAngle();     ///< 32 measured errors, the curve through them, tolerance lines
PlotSpec errorVersusStorage(); ///< five methods at every size, log-log, target and budget to drag
PlotSpec harmonics();          ///< 16 bars
PlotSpec residualSteps();      ///< lookup table over the curve, residual of linear segments
PlotSpec coverageRing();       ///< polar, three quarters measured
PlotSpec secondAxis();         ///< temperature beside drift
PlotSpec tinyRange();          ///< 1 + 1e-9·sin over epoch seconds

} // namespace straightedge::gui::figures
