// Raw samples as they were captured -> the sweep that is calibrated or verified.
#pragma once

#include "core/angle/sweep.h"
#include "core/session/sample_sink.h"

#include <vector>

namespace straightedge::gui {

/// One row per sample, in the plan's order of points, then of arrival; of a point that was measured again only the
/// latest attempt.
angle::Sweep capturedSweep(const std::vector<session::AngleSample>& samples);

} // namespace straightedge::gui
