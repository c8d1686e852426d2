// Captures an angle sweep into a session file.
#pragma once

#include "app/cli/capture_options.h"
#include "core/base/error.h"
#include "devices/simulated/simulated_angle_bench.h"

#include <optional>
#include <string>

namespace straightedge::cli {

/// Options of `capture angle`.
struct CaptureRequest : CaptureOptions {
  bool verification = false;
  // Plan
  std::optional<int> points;
  std::optional<int> turns;
  std::optional<bool> bothDirections;
  std::optional<double> settleS;
  std::optional<int> averages;
  std::optional<double> startDeg;
  std::optional<double> rateHz;
  std::optional<std::string> pairing; ///< "as-read" or "interpolate"; else what the bench says
  std::optional<double> pairingMaxAgeS;
  // Simulated bench
  std::optional<unsigned long long> seed;
  std::optional<devices::FieldGeometry> geometry;
  std::optional<bool> decreasing;
  std::optional<double> noiseDeg;
  std::optional<double> hysteresisDeg;
  std::optional<int> sensorBits;
  std::optional<double> mountingDeg;
};

/// Runs the capture to its end, with progress on a terminal. Everything taken is committed whatever happens.
/// Errors: Usage (plan, file exists), Input and Storage (session), Instrument (the sweep can be resumed), Cancelled
/// (interrupted by SIGINT or SIGTERM; the sweep can be resumed). Call from the main thread, before others are started.
Result<void> runCapture(const CaptureRequest& request);

} // namespace straightedge::cli
