// Plots and reports are drawn by the desktop application, so that there is one way to draw.
#pragma once

#include "core/base/error.h"

#include <functional>
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
/// Errors (Storage): not found; it failed (with what it said).
Result<void> renderWithoutDisplay(const RenderRequest& request);

/// The same for rows that came from `input`. Where the drawing program cannot read that file (standard input is read
/// only once, a session is no CSV file), it gets what `asCsv` makes of the rows, under `name`.
Result<void> renderRowsWithoutDisplay(RenderRequest request, const std::string& input, const std::string& name,
                                      const std::function<std::string()>& asCsv);

} // namespace straightedge::cli
