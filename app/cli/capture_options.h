// What the captures of an angle sweep and of a field campaign have in common: options, traceability, how they end.
#pragma once

#include "core/base/error.h"
#include "core/session/session.h"
#include "devices/capture/capture_control.h"
#include "devices/instruments/angle_instruments.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace straightedge::cli {

/// What was not given is empty and takes the default, or on --resume what the session says.
struct CaptureOptions {
  std::string bench;
  std::string session;
  std::string csv; ///< also write what was captured there; "-" is standard output
  bool resume = false;
  bool realTime = false;
  std::optional<int> retries; ///< of the plan
  double waitS = 600.0;       ///< for an instrument that was unplugged
  std::string dialogues;      ///< folder for recorded dialogues; empty: none are recorded
  // Traceability
  std::string serial;
  std::string deviceModel;
  std::string operatorName;
};

/// `sweep`: "sweep" or "campaign"; `device`: "sensor" or "teslameter".
void addCaptureOptions(CLI::App& command, CaptureOptions& options, const std::string& sweep, const std::string& device);

/// What a session learns of the bench before the first sample.
struct CaptureTraceability {
  std::optional<devices::InstrumentIdentity> device; ///< where the options say nothing and the session neither
  std::optional<devices::InstrumentIdentity> reference;
  std::optional<double> ambientC;
};
Result<void> storeTraceability(session::Session& session, const CaptureOptions& options,
                               const CaptureTraceability& known);

/// How a capture ended, as the command's outcome. `points`: "points", "plateaus and sweeps".
Result<void> captureOutcome(const devices::CaptureProgress& progress, const std::string& session,
                            const std::string& points);

} // namespace straightedge::cli
