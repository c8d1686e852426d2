#include "core/angle/repeatability.h"

#include "core/angle/angles.h"
#include "core/numerics/statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>
#include <vector>

namespace straightedge::angle {

namespace {

/// Readings of one encoder angle, direction and turn.
struct Cell {
  std::size_t group = 0;
  int pass = 1;
  double mean = 0.0; ///< of the error sensor − encoder
  double squares = 0.0;
  std::size_t count = 0;
};

std::vector<Cell> cellsOf(const AlignedSweep& aligned, const EncoderGroups& groups) {
  std::vector<std::size_t> order(groups.ofPoint.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&](std::size_t i) { return std::tuple(groups.ofPoint[i], aligned.pass[i], aligned.turn[i]); };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  std::vector<Cell> cells;
  for (std::size_t from = 0; from < order.size();) {
    std::size_t to = from;
    Cell cell{groups.ofPoint[order[from]], aligned.pass[order[from]], 0.0, 0.0, 0};
    for (; to < order.size() && key(order[to]) == key(order[from]); ++to) {
      cell.mean -= aligned.correctionDeg(static_cast<Eigen::Index>(order[to]));
    }
    cell.count = to - from;
    cell.mean /= static_cast<double>(cell.count);
    for (std::size_t i = from; i < to; ++i) {
      const double deviation = -aligned.correctionDeg(static_cast<Eigen::Index>(order[i])) - cell.mean;
      cell.squares += deviation * deviation;
    }
    cells.push_back(cell);
    from = to;
  }
  return cells;
}

/// Rising and falling error at one encoder angle: the turns' means, and how many there are.
struct Directions {
  std::array<double, 2> sum{};
  std::array<std::size_t, 2> turns{};
  bool both() const { return turns[0] > 0 && turns[1] > 0; }
  double mean(std::size_t side) const { return sum[side] / static_cast<double>(turns[side]); }
};

std::vector<double> encoderOfGroups(const AlignedSweep& aligned, const EncoderGroups& groups) {
  // Means about the first member, so that a group across the seam does not average to 180°.
  std::vector<double> first(groups.count, 0.0);
  std::vector<double> sum(groups.count, 0.0);
  std::vector<std::size_t> count(groups.count, 0);
  for (std::size_t i = 0; i < groups.ofPoint.size(); ++i) {
    const std::size_t g = groups.ofPoint[i];
    const double encoder = aligned.encoderDeg(static_cast<Eigen::Index>(i));
    if (count[g] == 0) {
      first[g] = encoder;
    }
    sum[g] += wrap180(encoder - first[g]);
    ++count[g];
  }
  for (std::size_t g = 0; g < groups.count; ++g) {
    sum[g] = wrap360(first[g] + sum[g] / static_cast<double>(count[g]));
  }
  return sum;
}

/// Scatter between the turns of one angle and direction. Where each turn holds several readings, the share that their
/// noise leaves in a turn's mean is taken off (one-way analysis of variance).
std::optional<double> betweenTurns(const std::vector<Cell>& cells, double noiseVariance) {
  numerics::PooledDeviation pooled;
  double noiseShare = 0.0;
  std::size_t cellsUsed = 0;
  for (std::size_t from = 0; from < cells.size();) {
    std::size_t to = from;
    double mean = 0.0;
    for (; to < cells.size() && cells[to].group == cells[from].group && cells[to].pass == cells[from].pass; ++to) {
      mean += cells[to].mean;
    }
    const std::size_t turns = to - from;
    mean /= static_cast<double>(turns);
    double squares = 0.0;
    for (std::size_t i = from; i < to; ++i) {
      squares += (cells[i].mean - mean) * (cells[i].mean - mean);
      if (turns > 1) {
        noiseShare += noiseVariance / static_cast<double>(cells[i].count);
        ++cellsUsed;
      }
    }
    pooled.add(squares, turns);
    from = to;
  }
  if (!pooled.isKnown()) {
    return std::nullopt;
  }
  return std::sqrt(std::max(0.0, pooled.variance() - noiseShare / static_cast<double>(cellsUsed)));
}

void measureHysteresis(const std::vector<Cell>& cells, const std::vector<double>& encoderOfGroup,
                       Repeatability& result) {
  std::vector<Directions> directions(encoderOfGroup.size());
  for (const Cell& cell : cells) {
    const std::size_t side = cell.pass > 0 ? 0 : 1;
    directions[cell.group].sum[side] += cell.mean;
    ++directions[cell.group].turns[side];
  }
  std::vector<std::size_t> order(directions.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return encoderOfGroup[a] < encoderOfGroup[b]; });
  double squares = 0.0;
  double largest = 0.0;
  for (const std::size_t g : order) {
    if (!directions[g].both()) {
      continue;
    }
    result.encoderDeg.push_back(encoderOfGroup[g]);
    result.risingMeanDeg.push_back(directions[g].mean(0));
    result.fallingMeanDeg.push_back(directions[g].mean(1));
    const double half = 0.5 * (result.risingMeanDeg.back() - result.fallingMeanDeg.back());
    result.hysteresisDeg.push_back(half);
    squares += half * half;
    largest = std::max(largest, std::abs(half));
  }
  if (!result.hysteresisDeg.empty()) {
    result.hysteresisMaxDeg = largest;
    result.hysteresisRmsDeg = std::sqrt(squares / static_cast<double>(result.hysteresisDeg.size()));
  }
}

} // namespace

Repeatability measureRepeatability(const AlignedSweep& aligned, const EncoderGroups& groups) {
  Repeatability result;
  if (groups.count == groups.ofPoint.size()) {
    return result; // every angle once: nothing repeats
  }
  const std::vector<Cell> cells = cellsOf(aligned, groups);
  numerics::PooledDeviation noise;
  for (const Cell& cell : cells) {
    noise.add(cell.squares, cell.count);
  }
  if (noise.isKnown()) {
    result.noiseDeg = std::sqrt(noise.variance());
  }
  result.repeatabilityDeg = betweenTurns(cells, noise.variance());
  measureHysteresis(cells, encoderOfGroups(aligned, groups), result);
  return result;
}

} // namespace straightedge::angle
