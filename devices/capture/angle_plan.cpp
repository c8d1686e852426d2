#include "devices/capture/angle_plan.h"

#include "core/base/number_text.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <optional>
#include <utility>

namespace straightedge::devices {

namespace {

constexpr int mostRetries = 100;
constexpr int fewestPoints = 8; // an alignment refuses fewer
constexpr int mostPoints = 36000;
constexpr int mostTurns = 1000;
constexpr int mostStations = 1000000;
constexpr int mostAverages = 10000;
constexpr double longestSettleS = 600.0;
constexpr double farthestStartDeg = 360000.0;
constexpr double slowestRateHz = 1.0;
constexpr double fastestRateHz = 1e6;

/// Whole numbers as such: 1000000, not 1e+06.
std::string shown(double value) {
  constexpr double largestShownWhole = 1e9;
  return value == std::trunc(value) && std::abs(value) < largestShownWhole
             ? std::to_string(static_cast<long long>(value))
             : formatDouble(value);
}

Result<void> inRange(const char* name, double value, double low, double high, const char* unit) {
  if (value >= low && value <= high) { // false for NaN
    return {};
  }
  return fail(ErrorKind::Usage, std::string(name) + " is " + shown(value) + unit,
              "give " + shown(low) + " to " + shown(high) + unit, "capture plan");
}

} // namespace

Result<void> checkPlan(const AnglePlan& plan) {
  std::optional<Error> problem;
  const auto note = [&problem](const Result<void>& outcome) {
    if (!outcome && !problem) {
      problem = outcome.error();
    }
  };
  note(inRange("the number of points per turn", plan.pointsPerTurn, fewestPoints, mostPoints, ""));
  note(inRange("the number of turns", plan.turns, 1, mostTurns, ""));
  note(inRange("the number of averages", plan.averages, 1, mostAverages, ""));
  note(inRange("the settling time", plan.settleS, 0.0, longestSettleS, " s"));
  note(inRange("the start angle", plan.startDeg, -farthestStartDeg, farthestStartDeg, "°"));
  note(inRange("the number of retries", plan.retries, 0, mostRetries, ""));
  note(inRange("the greatest age of a paired reading", plan.pairing.maxAgeS, 1e-6, 60.0, " s"));
  if (plan.sampleRateHz != 0.0) {
    note(inRange("the sample rate", plan.sampleRateHz, slowestRateHz, fastestRateHz, " Hz (or 0: point by point)"));
  }
  if (!problem) {
    const double stations = static_cast<double>(plan.pointsPerTurn) * plan.turns * (plan.bothDirections ? 2.0 : 1.0);
    note(inRange("the number of points in all turns and directions", stations, fewestPoints, mostStations, ""));
  }
  if (problem) {
    return std::unexpected(*problem);
  }
  return {};
}

std::vector<PlannedPoint> plannedPoints(const AnglePlan& plan) {
  std::vector<PlannedPoint> points;
  const int rising = plan.pointsPerTurn * plan.turns;
  points.reserve(static_cast<std::size_t>(rising) * (plan.bothDirections ? 2U : 1U));
  for (int i = 0; i < rising; ++i) {
    const int turn = i / plan.pointsPerTurn;
    const int withinTurn = i % plan.pointsPerTurn;
    // Not added up: the same angle comes out the same to the last bit in every turn and direction.
    const double angle = plan.startDeg + 360.0 * turn + 360.0 * withinTurn / plan.pointsPerTurn;
    points.push_back({.index = i, .turn = turn, .direction = 1, .encoderDeg = angle});
  }
  if (plan.bothDirections) {
    for (int i = rising - 1; i >= 0; --i) {
      PlannedPoint back = points[static_cast<std::size_t>(i)];
      back.index = 2 * rising - 1 - i;
      back.direction = -1;
      points.push_back(back);
    }
  }
  return points;
}

std::string planToJson(const AnglePlan& plan) {
  const nlohmann::ordered_json json = {{"kind", "angle"},
                                       {"points_per_turn", plan.pointsPerTurn},
                                       {"turns", plan.turns},
                                       {"both_directions", plan.bothDirections},
                                       {"start_deg", plan.startDeg},
                                       {"settle_s", plan.settleS},
                                       {"averages", plan.averages},
                                       {"sample_rate_hz", plan.sampleRateHz},
                                       {"pairing", pairingWord(plan.pairing.kind)},
                                       {"pairing_max_age_s", plan.pairing.maxAgeS},
                                       {"retries", plan.retries}};
  return json.dump();
}

Result<AnglePlan> planFromJson(std::string_view text) {
  AnglePlan plan;
  try {
    const nlohmann::json json = nlohmann::json::parse(text);
    plan.pointsPerTurn = json.at("points_per_turn").get<int>();
    plan.turns = json.value("turns", plan.turns);
    plan.bothDirections = json.value("both_directions", plan.bothDirections);
    plan.startDeg = json.value("start_deg", plan.startDeg);
    plan.settleS = json.value("settle_s", plan.settleS);
    plan.averages = json.value("averages", plan.averages);
    plan.sampleRateHz = json.value("sample_rate_hz", plan.sampleRateHz);
    plan.pairing.kind = pairingFromWord(json.value("pairing", std::string("as-read"))).value_or(PairingKind::AsRead);
    plan.pairing.maxAgeS = json.value("pairing_max_age_s", plan.pairing.maxAgeS);
    plan.retries = json.value("retries", plan.retries);
  } catch (const nlohmann::json::exception& problem) {
    return fail(ErrorKind::Input, std::string("the stored capture plan cannot be read (") + problem.what() + ")",
                "choose the plan anew", "capture plan");
  }
  if (auto checked = checkPlan(plan); !checked) {
    Error error = std::move(checked.error());
    error.kind = ErrorKind::Input;
    return std::unexpected(std::move(error));
  }
  return plan;
}

} // namespace straightedge::devices
