// What Review says about each row of a sweep: its error, how far it lies from what its neighbours foretell, and whether
// that is too far.
#pragma once

#include "core/angle/calibration.h"
#include "core/angle/sweep.h"
#include "core/base/job_control.h"

#include <cstddef>
#include <vector>

namespace straightedge::gui {

struct ReviewRow {
  double errorDeg = 0.0;    ///< reading − encoder in [−180°, 180°); reading is 360 − sensor for a decreasing sensor
  double residualDeg = 0.0; ///< correction minus what the other points foretell there; NaN where that is not known
  bool outlier = false;
};

/// Degrees.
struct ReviewAnalysis {
  std::vector<ReviewRow> rows;       ///< one per row of the sweep
  std::vector<std::size_t> outliers; ///< switched-on rows only
  double spreadDeg = 0.0;       ///< robust standard deviation of the residuals: 1.4826 times the median of |residual|
  double outlierLimitDeg = 0.0; ///< |residual| above it is an outlier; 0: there are no residuals
  bool fromNeighbours = false;  ///< residual about a cubic through four neighbours; otherwise about the curve
};

/// `run` is null where the sweep was refused: then there are errors, and no residuals. An interpolated curve passes
/// through every point, so a point is there compared with the cubic (Lagrange) through two neighbours on either side.
/// Errors: Cancelled.
Result<ReviewAnalysis> analyseForReview(const angle::Sweep& sweep, const angle::CalibrationRun* run,
                                        const JobControl& job = {});

} // namespace straightedge::gui
