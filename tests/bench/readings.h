// Inputs for the benchmarks, made on the spot in a folder that disappears.
#pragma once

#include "core/angle/calibration.h"

#include <cstddef>
#include <string>

namespace straightedge::bench {

/// The sweep of a side-shaft sensor with 32 points, as CSV; `seed` shifts it a little.
std::string sweepText(int seed);

/// Its calibration with the default models.
angle::AngleCalibration sampleCalibration();

/// Rows of about 20 bytes: "NNNNNNNN,SSS.sssssss". At least `bytes` in all, with a header.
std::string readingsText(std::size_t bytes);

} // namespace straightedge::bench
