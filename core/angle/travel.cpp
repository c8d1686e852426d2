#include "core/angle/travel.h"

#include "core/angle/angles.h"
#include "core/numerics/statistics.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace straightedge::angle {

namespace {

constexpr double reversalDeg = 45.0;
/// Passes shorter than this on average mean that the rows' order tells nothing.
constexpr std::size_t fewestRowsPerPass = 8;

/// Encoder angles continued over the seam: what exceeds 360 already is continuous, what wraps is made so.
std::vector<double> continued(const Sweep& sweep, const std::vector<std::size_t>& rows) {
  std::vector<double> position(rows.size());
  position.front() = sweep.encoderDeg[rows.front()];
  for (std::size_t i = 1; i < rows.size(); ++i) {
    position[i] = position[i - 1] + wrap180(sweep.encoderDeg[rows[i]] - sweep.encoderDeg[rows[i - 1]]);
  }
  return position;
}

/// Rows that follow one another this near were taken at one stop of the shaft.
constexpr double stopDeg = 0.02;

/// Usual number of rows taken at one stop.
double usualStop(const std::vector<double>& position) {
  std::vector<double> lengths;
  std::size_t begin = 0;
  for (std::size_t i = 1; i <= position.size(); ++i) {
    if (i == position.size() || std::abs(position[i] - position[i - 1]) > stopDeg) {
      lengths.push_back(static_cast<double>(i - begin));
      begin = i;
    }
  }
  return numerics::median(std::move(lengths));
}

/// First row of the pass that begins at the turning point in row `extreme`. A stop there that holds about twice as many
/// rows as usual was visited in both directions without moving between: the later half belongs to the new pass.
std::size_t firstRowAfterTurning(const std::vector<double>& position, std::size_t extreme, double usual) {
  std::size_t first = extreme;
  std::size_t last = extreme;
  while (first > 0 && std::abs(position[first - 1] - position[extreme]) <= stopDeg) {
    --first;
  }
  while (last + 1 < position.size() && std::abs(position[last + 1] - position[extreme]) <= stopDeg) {
    ++last;
  }
  const std::size_t rows = last + 1 - first;
  return static_cast<double>(rows) >= 1.5 * usual && rows > 1 ? first + (rows + 1) / 2 : last + 1;
}

struct Passes {
  std::vector<int> sign; ///< per row
  std::size_t count = 1;
};

Passes passesOf(const std::vector<double>& position) {
  Passes passes;
  passes.sign.assign(position.size(), 0);
  const double usual = usualStop(position);
  std::size_t begin = 0;
  std::size_t extreme = 0; // row of the furthest position of the pass so far
  int sign = 0;
  for (std::size_t i = 1; i < position.size(); ++i) {
    const double ahead = position[i] - position[extreme];
    if (sign == 0) {
      if (std::abs(position[i] - position[0]) >= reversalDeg) {
        sign = position[i] > position[0] ? 1 : -1;
        extreme = i;
      }
    } else if (ahead * sign >= 0.0) {
      extreme = i;
    } else if (ahead * sign <= -reversalDeg) {
      const std::size_t next = firstRowAfterTurning(position, extreme, usual);
      std::fill(passes.sign.begin() + static_cast<std::ptrdiff_t>(begin),
                passes.sign.begin() + static_cast<std::ptrdiff_t>(next), sign);
      begin = next;
      sign = -sign;
      extreme = i;
      ++passes.count;
    }
  }
  std::fill(passes.sign.begin() + static_cast<std::ptrdiff_t>(begin), passes.sign.end(), sign == 0 ? 1 : sign);
  return passes;
}

std::vector<int> turnsFromPosition(const std::vector<double>& position) {
  const auto [low, high] = std::minmax_element(position.begin(), position.end());
  const double span = *high - *low;
  // A sweep that ends where it began, 0 to 360, is one turn.
  constexpr double closingDeg = 1e-6;
  const int last = std::max(0, static_cast<int>(std::ceil((span - closingDeg) / 360.0)) - 1);
  std::vector<int> turn(position.size());
  for (std::size_t i = 0; i < position.size(); ++i) {
    turn[i] = std::min(last, static_cast<int>(std::floor((position[i] - *low + closingDeg) / 360.0)));
  }
  return turn;
}

} // namespace

Travel recoverTravel(const Sweep& sweep, const std::vector<std::size_t>& rows) {
  Travel travel;
  if (rows.empty()) {
    return travel;
  }
  const std::vector<double> position = continued(sweep, rows);
  const Passes passes = passesOf(position);
  const bool ordered = passes.count == 1 || rows.size() / passes.count >= fewestRowsPerPass;
  const auto recorded = [&](const std::vector<int>& column) {
    std::vector<int> values(rows.size());
    std::transform(rows.begin(), rows.end(), values.begin(), [&](std::size_t row) { return column[row]; });
    return values;
  };

  if (!sweep.direction.empty()) {
    travel.pass = recorded(sweep.direction);
    for (int& sign : travel.pass) {
      sign = sign < 0 ? -1 : 1;
    }
  } else {
    travel.pass = ordered ? passes.sign : std::vector<int>(rows.size(), 1);
  }
  if (!sweep.turn.empty()) {
    travel.turn = recorded(sweep.turn);
  } else if (ordered) {
    travel.turn = turnsFromPosition(position);
  } else {
    std::vector<double> raw(rows.size());
    std::transform(rows.begin(), rows.end(), raw.begin(), [&](std::size_t row) { return sweep.encoderDeg[row]; });
    travel.turn = turnsFromPosition(raw);
  }
  const auto [first, last] = std::minmax_element(travel.turn.begin(), travel.turn.end());
  travel.turns = *last - *first + 1;
  const bool rising = std::find(travel.pass.begin(), travel.pass.end(), 1) != travel.pass.end();
  const bool falling = std::find(travel.pass.begin(), travel.pass.end(), -1) != travel.pass.end();
  travel.bothDirections = rising && falling;
  return travel;
}

} // namespace straightedge::angle
