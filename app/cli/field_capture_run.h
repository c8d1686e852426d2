// Captures a field campaign into a session file.
#pragma once

#include "app/cli/capture_options.h"
#include "core/base/error.h"

#include <optional>
#include <string>
#include <vector>

namespace straightedge::cli {

/// Options of `capture field`.
struct FieldCaptureRequest : CaptureOptions {
  bool yes = false; ///< what a person is asked to do is taken as done at once
  // Plan
  std::vector<std::string> stages;
  std::vector<std::string> axes;
  std::vector<double> fieldsT;
  std::vector<double> temperaturesC; ///< low and high
  std::optional<int> rows;
  std::optional<int> sweepRows;
  std::optional<double> rowS;
  std::optional<double> settleS;
  std::optional<double> temperatureSettleS;
  std::optional<double> lockTimeoutS;
  // Simulated bench
  std::optional<unsigned long long> seed;
  std::optional<double> noiseT;
  std::optional<double> planarHallPerT;
  std::optional<double> probeLagS;
};

/// Runs the capture to its end, with progress on a terminal. Everything taken is committed whatever happens.
/// Errors: Usage (plan, file exists), Input and Storage (session), Instrument (the campaign can be resumed), Cancelled
/// (interrupted by SIGINT or SIGTERM; the campaign can be resumed), Usage also where nobody is there to do what a stage
/// asks for. Call from the main thread, before others are started.
Result<void> runFieldCapture(const FieldCaptureRequest& request);

} // namespace straightedge::cli
