// What to capture: the plan of an angle sweep.
#pragma once

#include "core/base/error.h"
#include "devices/instruments/pairing_rule.h"

#include <string>
#include <string_view>
#include <vector>

namespace straightedge::devices {

struct AnglePlan {
  int pointsPerTurn = 64;
  int turns = 1;
  bool bothDirections = false;
  double startDeg = 0.0;
  double settleS = 0.05;
  int averages = 1; ///< readings per point; each is stored as a sample of its own
  double sampleRateHz =
      0.0;                  ///< > 0: free-running capture at this rate while the shaft turns, instead of point by point
  PairingRule pairing = {}; ///< stepwise: how encoder and sensor readings become one sample
  int retries = 2;          ///< times that a reading is asked for again after a time-out, before the capture pauses

  bool operator==(const AnglePlan&) const = default;
};

/// One station of a stepwise plan.
struct PlannedPoint {
  int index = 0;
  int turn = 0;
  int direction = 1;
  double encoderDeg = 0.0; ///< where the shaft is to stand, unwrapped
};

/// Errors (Usage): too few or too many points, negative times, … with the allowed range.
Result<void> checkPlan(const AnglePlan& plan);
std::vector<PlannedPoint> plannedPoints(const AnglePlan& plan);

/// JSON for the session's "plan" document.
std::string planToJson(const AnglePlan& plan);
Result<AnglePlan> planFromJson(std::string_view json);

} // namespace straightedge::devices
