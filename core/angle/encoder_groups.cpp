#include "core/angle/encoder_groups.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace straightedge::angle {

namespace {

/// Nearer than this are rounding differences of one and the same angle.
constexpr double equalDeg = 1e-9;
/// How far a stage may miss a place it comes back to.
constexpr double returnDeg = 0.02;
constexpr double clearlyNearer = 10.0;
/// One gap in dense data is a gap, not a sign of groups.
constexpr std::size_t fewestGroups = 3;

/// Distances to the next point round the circle, the last back to the first.
std::vector<double> distancesRound(const Eigen::VectorXd& encoderDeg, const std::vector<Eigen::Index>& order) {
  std::vector<double> distance(order.size());
  for (std::size_t i = 0; i + 1 < order.size(); ++i) {
    distance[i] = encoderDeg(order[i + 1]) - encoderDeg(order[i]);
  }
  distance.back() = encoderDeg(order.front()) + 360.0 - encoderDeg(order.back());
  return distance;
}

/// Distance up to which neighbours belong together: below the widest step in the sorted distances, if there is one.
double joiningDistance(std::vector<double> distance) {
  std::sort(distance.begin(), distance.end());
  double joining = equalDeg;
  double widestRatio = clearlyNearer;
  for (std::size_t i = 0; i + fewestGroups < distance.size(); ++i) {
    const double near = std::max(distance[i], equalDeg);
    if (near > returnDeg) {
      break;
    }
    const double ratio = distance[i + 1] / near;
    if (ratio >= widestRatio && distance[i + 1] > equalDeg) {
      widestRatio = ratio;
      joining = near;
    }
  }
  return joining;
}

EncoderGroups sectors(const Eigen::VectorXd& encoderDeg, std::size_t most) {
  EncoderGroups groups;
  groups.ofPoint.resize(static_cast<std::size_t>(encoderDeg.size()));
  std::vector<std::size_t> number(most, 0);
  for (std::size_t i = 0; i < groups.ofPoint.size(); ++i) {
    const double share = encoderDeg(static_cast<Eigen::Index>(i)) / 360.0;
    groups.ofPoint[i] = std::min(static_cast<std::size_t>(share * static_cast<double>(most)), most - 1);
    number[groups.ofPoint[i]] = 1;
  }
  for (std::size_t& n : number) {
    const bool occupied = n != 0;
    n = groups.count;
    groups.count += occupied ? 1 : 0;
  }
  for (std::size_t& g : groups.ofPoint) {
    g = number[g];
  }
  return groups;
}

} // namespace

EncoderGroups groupEncoderAngles(const Eigen::VectorXd& encoderDeg, std::size_t most) {
  EncoderGroups groups;
  groups.ofPoint.resize(static_cast<std::size_t>(encoderDeg.size()));
  if (groups.ofPoint.empty()) {
    return groups;
  }
  std::vector<Eigen::Index> order(groups.ofPoint.size());
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) { return encoderDeg(a) < encoderDeg(b); });
  const std::vector<double> distance = distancesRound(encoderDeg, order);
  const double joining = joiningDistance(distance);

  double groupStart = encoderDeg(order.front());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const double angle = encoderDeg(order[i]);
    // A chain of small steps must not swallow the whole circle.
    const bool startsAnew = i > 0 && (distance[i - 1] > joining || angle - groupStart > 2.0 * returnDeg);
    if (startsAnew) {
      ++groups.count;
      groupStart = angle;
    }
    groups.ofPoint[static_cast<std::size_t>(order[i])] = groups.count;
  }
  ++groups.count;
  // The seam: points just below 360° belong to the group just above 0°.
  if (groups.count > 1 && distance.back() <= joining) {
    for (std::size_t& g : groups.ofPoint) {
      g = g == groups.count - 1 ? 0 : g;
    }
    --groups.count;
  }
  return groups.count > most ? sectors(encoderDeg, most) : groups;
}

} // namespace straightedge::angle
