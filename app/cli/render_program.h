// Plots and reports are drawn by the desktop application, so that there is one way to draw.
#pragma once

#include "core/base/error.h"

#include <optional>
#include <string>

namespace straightedge::cli {

struct RenderRequest {
  std::string calibration;          ///< path of calibration.json
  std::string out;                  ///< folder
  std::optional<std::string> sweep; ///< path of the sweep, for plots of the data
  bool plots = false;
  bool report = false;
};

/// Starts `straightedge --render` found beside this program, or on PATH, without a display, and waits for it.
/// Errors (Storage): not found; it failed (with its own first line).
Result<void> renderWithoutDisplay(const RenderRequest& request);

} // namespace straightedge::cli
