#include "core/angle/turning_check.h"

#include "core/angle/angles.h"
#include "core/angle/messages.h"
#include "core/base/number_text.h"
#include "core/numerics/statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

namespace straightedge::angle {

namespace {

/// A sensor whose readings all stay this near to one another does not follow the shaft.
constexpr double standingStillDeg = 5.0;
/// Neighbours may differ by this, and by as much again as the shaft moved between them.
constexpr double scatterDeg = 10.0;
constexpr double driftPerTurnDeg = 2.0;
/// A jump of 1 % of a turn or more is looked at.
constexpr double smallestJumpDeg = 3.6;

std::string turnRemedy() { return "check the gear ratio, the magnet's pole pairs and which column is which"; }

/// Steps between neighbours on the encoder's circle, the last back to the first.
struct Steps {
  std::vector<double> fromDeg;   ///< encoder angle where the step begins
  std::vector<double> shaftDeg;  ///< ≥ 0
  std::vector<double> sensorDeg; ///< in [−180, 180)
};

Steps stepsRound(const Eigen::VectorXd& encoderDeg, const Eigen::VectorXd& sensorDeg) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(encoderDeg.size()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
    return encoderDeg(a) != encoderDeg(b) ? encoderDeg(a) < encoderDeg(b) : sensorDeg(a) < sensorDeg(b);
  });
  Steps steps;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool last = i + 1 == order.size();
    const Eigen::Index here = order[i];
    const Eigen::Index next = order[last ? 0 : i + 1];
    steps.fromDeg.push_back(encoderDeg(here));
    steps.shaftDeg.push_back(encoderDeg(next) - encoderDeg(here) + (last ? 360.0 : 0.0));
    steps.sensorDeg.push_back(wrap180(sensorDeg(next) - sensorDeg(here)));
  }
  return steps;
}

/// Steps merged to about 72 longer ones, so that noise does not hide a slow drift.
Steps merged(const Steps& steps) {
  constexpr double lengthDeg = 5.0;
  Steps result;
  for (std::size_t i = 0; i < steps.shaftDeg.size(); ++i) {
    if (!result.shaftDeg.empty() && result.shaftDeg.back() + steps.shaftDeg[i] <= lengthDeg) {
      result.shaftDeg.back() += steps.shaftDeg[i];
      result.sensorDeg.back() += steps.sensorDeg[i];
    } else {
      result.fromDeg.push_back(steps.fromDeg[i]);
      result.shaftDeg.push_back(steps.shaftDeg[i]);
      result.sensorDeg.push_back(steps.sensorDeg[i]);
    }
  }
  return result;
}

/// A sensor of r turns, r not whole, drifts against the encoder all the way and jumps back once, where the recorded
/// turn is closed. Told from a real correction by both: the one step back undoes nearly all the rest, and the usual
/// slope of the others already explains it (one bad reading has no such slope).
std::optional<Error> refuseSawtooth(const Sweep& sweep, const Steps& steps, int sign) {
  const std::size_t n = steps.shaftDeg.size();
  std::vector<double> correction(n);
  double variation = 0.0;
  std::size_t jump = 0;
  for (std::size_t i = 0; i < n; ++i) {
    correction[i] = steps.shaftDeg[i] - sign * steps.sensorDeg[i];
    variation += std::abs(correction[i]);
    jump = std::abs(correction[i]) > std::abs(correction[jump]) ? i : jump;
  }
  const double size = std::abs(correction[jump]);
  if (size < smallestJumpDeg || size < 0.8 * 0.5 * variation) {
    return std::nullopt;
  }
  std::vector<double> slopes;
  for (std::size_t i = 0; i < n; ++i) {
    if (i != jump && steps.shaftDeg[i] > 0.0) {
      slopes.push_back(correction[i] / steps.shaftDeg[i]);
    }
  }
  const double drift = numerics::median(std::move(slopes)) * (360.0 - steps.shaftDeg[jump]);
  if (drift * correction[jump] > 0.0 || std::abs(drift) < 0.7 * size) {
    return std::nullopt;
  }
  return sweepError(
      sweep,
      "the sensor seems to make " + formatForPeople(1.0 - drift / 360.0, 2) +
          " turns while the encoder makes one: it drifts steadily against the encoder and jumps back by " +
          degreesText(size) + " after encoder angle " + degreesText(steps.fromDeg[jump]) + "; it must make exactly one",
      turnRemedy());
}

} // namespace

std::optional<Error> refuseTurning(const Sweep& sweep, const Eigen::VectorXd& encoderDeg,
                                   const Eigen::VectorXd& sensorDeg, SensorDirection& direction) {
  const Steps steps = stepsRound(encoderDeg, sensorDeg);
  double position = 0.0;
  double low = 0.0;
  double high = 0.0;
  for (const double step : steps.sensorDeg) {
    position += step;
    low = std::min(low, position);
    high = std::max(high, position);
  }
  if (high - low <= standingStillDeg) {
    return sweepError(
        sweep,
        high - low > 0.0
            ? "the sensor stays within " + degreesText(high - low) + " while the encoder makes a whole turn"
            : "the sensor shows the same angle, " + degreesText(sensorDeg(0)) + ", at every encoder angle",
        "check the sensor's wiring and that the magnet turns with the shaft");
  }

  const auto turns = static_cast<int>(std::lround(position / 360.0));
  std::vector<double> unruly;
  unruly.reserve(steps.shaftDeg.size());
  for (std::size_t i = 0; i < steps.shaftDeg.size(); ++i) {
    unruly.push_back(std::abs(wrap180(steps.sensorDeg[i] - turns * steps.shaftDeg[i])));
  }
  const double scatter = numerics::median(std::move(unruly));
  if (scatter > scatterDeg + numerics::median(steps.shaftDeg)) {
    return sweepError(sweep,
                      "the sensor does not come back to the same angle: readings at neighbouring encoder angles differ "
                      "by " +
                          degreesText(scatter) + " (median); it must make exactly one turn while the encoder makes one",
                      turnRemedy());
  }
  if (turns == 0) {
    return sweepError(sweep,
                      "the sensor turns less than once while the encoder makes one turn: it comes back after " +
                          degreesText(high - low) + "; it must make exactly one",
                      turnRemedy());
  }
  if (std::abs(turns) > 1) {
    return sweepError(sweep,
                      "the sensor makes " + std::to_string(std::abs(turns)) +
                          " turns while the encoder makes one; it must make exactly one",
                      turnRemedy());
  }
  direction = turns > 0 ? SensorDirection::Increasing : SensorDirection::Decreasing;
  return refuseSawtooth(sweep, merged(steps), turns);
}

std::optional<Error> refuseDrift(const Sweep& sweep, const AlignedSweep& aligned) {
  if (aligned.passes.turns < 2) {
    return std::nullopt;
  }
  std::vector<Eigen::Index> order(aligned.turn.size());
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::sort(order.begin(), order.end(),
            [&](Eigen::Index a, Eigen::Index b) { return aligned.encoderDeg(a) < aligned.encoderDeg(b); });
  std::vector<double> perTurn;
  for (std::size_t i = 1; i < order.size(); ++i) {
    const auto here = static_cast<std::size_t>(order[i]);
    const auto before = static_cast<std::size_t>(order[i - 1]);
    const int turns = aligned.turn[here] - aligned.turn[before];
    if (turns != 0 && aligned.pass[here] == aligned.pass[before]) {
      perTurn.push_back(-(aligned.correctionDeg(order[i]) - aligned.correctionDeg(order[i - 1])) / turns);
    }
  }
  constexpr std::size_t fewestPairs = 8;
  if (perTurn.size() < fewestPairs) {
    return std::nullopt;
  }
  const double drift = numerics::median(std::move(perTurn));
  if (std::abs(drift) <= driftPerTurnDeg) {
    return std::nullopt;
  }
  return sweepError(sweep,
                    "the sensor " + std::string(drift > 0.0 ? "gains " : "loses ") + degreesText(std::abs(drift)) +
                        " against the encoder with every turn; it must make exactly one turn while the encoder makes "
                        "one",
                    turnRemedy());
}

} // namespace straightedge::angle
