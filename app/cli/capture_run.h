// Captures an angle sweep into a session file.
#pragma once

#include "core/base/error.h"
#include "devices/simulated/simulated_angle_bench.h"

#include <optional>
#include <string>

namespace straightedge::cli {

/// Options of `capture angle`; what was not given is empty and takes the default, or on --resume what the session says.
struct CaptureRequest {
  std::string bench;
  std::string session;
  std::string csv; ///< also write the sweep there; "-" is standard output
  bool resume = false;
  bool verification = false;
  bool realTime = false;
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
  std::optional<int> retries;
  double waitS = 600.0; ///< for an instrument that was unplugged
  // Simulated bench
  std::optional<unsigned long long> seed;
  std::optional<devices::FieldGeometry> geometry;
  std::optional<bool> decreasing;
  std::optional<double> noiseDeg;
  std::optional<double> hysteresisDeg;
  std::optional<int> sensorBits;
  std::optional<double> mountingDeg;
  // Traceability
  std::string serial;
  std::string deviceModel;
  std::string operatorName;
};

/// Runs the capture to its end, with progress on a terminal. Everything taken is committed whatever happens.
/// Errors: Usage (plan, file exists), Input and Storage (session), Instrument (the sweep can be resumed), Cancelled
/// (interrupted by SIGINT or SIGTERM; the sweep can be resumed). Call from the main thread, before others are started.
Result<void> runCapture(const CaptureRequest& request);

} // namespace straightedge::cli
