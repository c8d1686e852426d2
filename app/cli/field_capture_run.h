// Captures a field campaign into a session file.
#pragma once

#include "core/base/error.h"

#include <optional>
#include <string>
#include <vector>

namespace straightedge::cli {

/// Options of `capture field`; what was not given is empty and takes the default, or on --resume what the session says.
struct FieldCaptureRequest {
  std::string bench;
  std::string session;
  std::string csv; ///< also write the campaign there; "-" is standard output
  bool resume = false;
  bool realTime = false;
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
  // Traceability
  std::string serial;
  std::string deviceModel;
  std::string operatorName;
};

/// Runs the capture to its end, with progress on a terminal. Everything taken is committed whatever happens.
/// Errors: Usage (plan, file exists), Input and Storage (session), Instrument (the campaign can be resumed), Cancelled
/// (interrupted by SIGINT or SIGTERM; the campaign can be resumed). Call from the main thread, before others are
/// started.
Result<void> runFieldCapture(const FieldCaptureRequest& request);

} // namespace straightedge::cli
