#include "core/angle/alignment.h"

#include "core/angle/angles.h"
#include "core/angle/encoder_groups.h"
#include "core/angle/repeatability.h"
#include "core/angle/sweep_checks.h"
#include "core/angle/travel.h"
#include "core/angle/turning_check.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace straightedge::angle {

namespace {

/// One value per encoder group, groups in ascending encoder order.
struct GroupMeans {
  Eigen::VectorXd encoderDeg;
  Eigen::VectorXd sensorDeg;
};

GroupMeans meansOf(const Eigen::VectorXd& encoder, const Eigen::VectorXd& sensor, const EncoderGroups& groups) {
  const auto count = static_cast<Eigen::Index>(groups.count);
  Eigen::VectorXd firstEncoder(count);
  Eigen::VectorXd firstSensor(count);
  Eigen::VectorXd encoderSum = Eigen::VectorXd::Zero(count);
  Eigen::VectorXd sensorSum = Eigen::VectorXd::Zero(count);
  Eigen::VectorXd members = Eigen::VectorXd::Zero(count);
  for (Eigen::Index i = 0; i < encoder.size(); ++i) {
    const auto g = static_cast<Eigen::Index>(groups.ofPoint[static_cast<std::size_t>(i)]);
    if (members(g) == 0.0) {
      firstEncoder(g) = encoder(i);
      firstSensor(g) = sensor(i);
    }
    // About the first member: readings on both sides of the seam must not average to its opposite.
    encoderSum(g) += wrap180(encoder(i) - firstEncoder(g));
    sensorSum(g) += wrap180(sensor(i) - firstSensor(g));
    members(g) += 1.0;
  }
  GroupMeans means{Eigen::VectorXd(count), Eigen::VectorXd(count)};
  std::vector<Eigen::Index> order(groups.count);
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  for (Eigen::Index g = 0; g < count; ++g) {
    firstEncoder(g) = wrap360(firstEncoder(g) + encoderSum(g) / members(g));
    firstSensor(g) = wrap360(firstSensor(g) + sensorSum(g) / members(g));
  }
  std::sort(order.begin(), order.end(),
            [&](Eigen::Index a, Eigen::Index b) { return firstEncoder(a) < firstEncoder(b); });
  for (Eigen::Index g = 0; g < count; ++g) {
    means.encoderDeg(g) = firstEncoder(order[static_cast<std::size_t>(g)]);
    means.sensorDeg(g) = firstSensor(order[static_cast<std::size_t>(g)]);
  }
  return means;
}

double towardsIncreasing(double sensorDeg, SensorDirection direction) {
  return direction == SensorDirection::Increasing ? sensorDeg : wrap360(360.0 - sensorDeg);
}

/// Corrections in the order of the readings, continued over ±180°, their mean in [−180, 180).
Eigen::VectorXd continuousCorrection(const Eigen::VectorXd& encoder, const Eigen::VectorXd& reading) {
  Eigen::VectorXd correction(reading.size());
  correction(0) = wrap180(encoder(0) - reading(0));
  for (Eigen::Index i = 1; i < reading.size(); ++i) {
    correction(i) = correction(i - 1) + wrap180(encoder(i) - reading(i) - correction(i - 1));
  }
  const double mean = correction.mean();
  const double turns = std::round((wrap180(mean) - mean) / 360.0);
  if (turns != 0.0) {
    correction.array() += 360.0 * turns;
  }
  return correction;
}

/// Whether the encoder stands still or steps back somewhere on the way up the readings, the step over the seam
/// included.
bool stepsBack(const AlignedSweep& aligned) {
  const Eigen::Index n = aligned.readingDeg.size();
  for (Eigen::Index i = 0; i < n; ++i) {
    const bool last = i + 1 == n;
    const Eigen::Index next = last ? 0 : i + 1;
    const double step = aligned.readingDeg(next) - aligned.readingDeg(i) + (last ? 360.0 : 0.0);
    const double encoderStep = step + aligned.correctionDeg(next) - aligned.correctionDeg(i);
    if (step <= 0.0 || encoderStep <= 0.0) {
      return true;
    }
  }
  return false;
}

} // namespace

Result<AlignedSweep> alignSweep(const Sweep& sweep) {
  if (auto error = refuseUnreadable(sweep)) {
    return std::unexpected(std::move(*error));
  }
  std::vector<std::size_t> rows;
  rows.reserve(sweep.size());
  for (std::size_t row = 0; row < sweep.size(); ++row) {
    if (sweep.isEnabled(row)) {
      rows.push_back(row);
    }
  }
  Eigen::VectorXd encoder(static_cast<Eigen::Index>(rows.size()));
  Eigen::VectorXd sensor(encoder.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    encoder(static_cast<Eigen::Index>(i)) = wrap360(sweep.encoderDeg[rows[i]]);
    sensor(static_cast<Eigen::Index>(i)) = wrap360(sweep.sensorDeg[rows[i]]);
  }
  const EncoderGroups groups = groupEncoderAngles(encoder);
  const GroupMeans means = meansOf(encoder, sensor, groups);
  if (auto error = refuseCoverage(sweep, means.encoderDeg)) {
    return std::unexpected(std::move(*error));
  }
  AlignedSweep aligned;
  if (auto error = refuseTurning(sweep, encoder, sensor, aligned.direction)) {
    return std::unexpected(std::move(*error));
  }

  // Sorted by reading; equal readings in the order of their encoder angles, so that the rows' order does not matter.
  Eigen::VectorXd reading(sensor.size());
  for (Eigen::Index i = 0; i < sensor.size(); ++i) {
    reading(i) = towardsIncreasing(sensor(i), aligned.direction);
  }
  std::vector<Eigen::Index> order(rows.size());
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
    return reading(a) != reading(b) ? reading(a) < reading(b) : encoder(a) < encoder(b);
  });

  const Travel travel = recoverTravel(sweep, rows);
  EncoderGroups sortedGroups{std::vector<std::size_t>(rows.size()), groups.count};
  aligned.readingDeg.resize(reading.size());
  aligned.encoderDeg.resize(reading.size());
  aligned.row.resize(rows.size());
  aligned.turn.resize(rows.size());
  aligned.pass.resize(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto from = static_cast<std::size_t>(order[i]);
    aligned.readingDeg(static_cast<Eigen::Index>(i)) = reading(order[i]);
    aligned.encoderDeg(static_cast<Eigen::Index>(i)) = encoder(order[i]);
    aligned.row[i] = rows[from];
    aligned.turn[i] = travel.turn[from];
    aligned.pass[i] = travel.pass[from];
    sortedGroups.ofPoint[i] = groups.ofPoint[from];
  }
  aligned.correctionDeg = continuousCorrection(aligned.encoderDeg, aligned.readingDeg);
  aligned.distinctAngles = groups.count;
  aligned.repeats = groups.count < rows.size() || stepsBack(aligned);

  Eigen::VectorXd distinctReading(means.sensorDeg.size());
  for (Eigen::Index i = 0; i < distinctReading.size(); ++i) {
    distinctReading(i) = towardsIncreasing(means.sensorDeg(i), aligned.direction);
  }
  std::sort(distinctReading.begin(), distinctReading.end());
  if (auto error = measureGaps(sweep, distinctReading, aligned)) {
    return std::unexpected(std::move(*error));
  }
  aligned.passes = measureRepeatability(aligned, sortedGroups);
  aligned.passes.turns = travel.turns;
  aligned.passes.bothDirections = travel.bothDirections;
  if (auto error = refuseDrift(sweep, aligned)) {
    return std::unexpected(std::move(*error));
  }
  noteWarnings(aligned);
  return aligned;
}

} // namespace straightedge::angle
