// What `angle fit` tells on the terminal: a short table.
#pragma once

#include "core/angle/calibration.h"

#include <string>
#include <vector>

namespace straightedge::cli {

/// Rows of text in columns, the first one to the left, the others to the right. Every line ends with a newline.
std::string alignedColumns(const std::vector<std::vector<std::string>>& rows);

/// Where the data came from, how the curve was made, and a row per model with its storage and errors.
std::string summaryOf(const angle::AngleCalibration& calibration);

} // namespace straightedge::cli
