#include "core/angle/minimax_chain.h"

#include "core/angle/bin_walk.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace straightedge::angle {

// A sample c at fraction t of a segment between values y and y' demands c − e ≤ (1 − t)·y + t·y' ≤ c + e. With the
// reach r = 1/t this bounds the next node by y + (c − e − y)·r ≤ y' ≤ y + (c + e − y)·r: both limits fall with y, the
// largest lower limit is convex in y and the smallest upper limit concave. Values of y for which they cross are
// impossible; the rest is an interval, and so is what remains for y'.

namespace {
constexpr double overflowGuard = 1e150;
}

struct MinimaxChain::Weights {
  std::vector<double> value; ///< positive: the sample's lower limit, negative: its upper limit
  explicit Weights(std::size_t samples) : value(samples, 0.0) {}
  void add(int sample, double weight) { value[static_cast<std::size_t>(sample)] += weight; }
  void scale(double factor) {
    for (double& weight : value) {
      weight *= factor;
    }
  }
};

MinimaxChain::MinimaxChain(const Eigen::VectorXd& curve, int size)
    : m_curve(&curve), m_size(static_cast<std::size_t>(size)), m_node(m_size + 1) {
  const int count = static_cast<int>(curve.size());
  for (int k = 0; k <= size; ++k) {
    m_begin.push_back(firstOfBin(k, size, count));
  }
  for (int i = 0; i < count; ++i) {
    const long long into = static_cast<long long>(i) * size % count;
    m_fraction.push_back(static_cast<double>(into) / count);
    m_reach.push_back(into == 0 ? 0.0 : static_cast<double>(count) / static_cast<double>(into));
  }
}

MinimaxChain::Extremes MinimaxChain::nextNode(std::size_t segment, double value, double error) const {
  const double* const curve = m_curve->data();
  const int begin = m_begin[segment];
  const int end = m_begin[segment + 1];
  const int first = m_reach[static_cast<std::size_t>(begin)] == 0.0 ? begin + 1 : begin;
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  Extremes extremes;
  for (int i = first; i < end; ++i) {
    const double distance = curve[i] - value;
    const double low = (distance - error) * reach(i);
    const double high = (distance + error) * reach(i);
    if (low > least) {
      least = low;
      extremes.lower = i;
    }
    if (high < most) {
      most = high;
      extremes.upper = i;
    }
  }
  extremes.least = value + least;
  extremes.most = value + most;
  return extremes;
}

bool MinimaxChain::clipToNodeSample(std::size_t segment, double error) {
  const int sample = m_begin[segment];
  Interval& node = m_node[segment];
  if (reach(sample) == 0.0) {
    const double value = (*m_curve)[sample];
    if (value - error > node.least.value) {
      node.least = {value - error, Origin::NodeSample, sample, -1};
    }
    if (value + error < node.most.value) {
      node.most = {value + error, Origin::NodeSample, -1, sample};
    }
  }
  return node.least.value <= node.most.value;
}

/// Lowers the upper end until the limits on the next node no longer cross there (Newton's steps on a convex function:
/// each ends at a value that the crossing pair of samples forbids to exceed). False: nothing is left, weights say why.
bool MinimaxChain::narrowFromAbove(std::size_t segment, double error, Weights& weights) {
  Interval& node = m_node[segment];
  for (;;) {
    const Extremes next = nextNode(segment, node.most.value, error);
    const double crossing = next.least - next.most;
    const bool samePair =
        node.most.origin == Origin::Pair && node.most.lower == next.lower && node.most.upper == next.upper;
    if (crossing <= 0.0 || samePair) {
      return true;
    }
    const double growth = reach(next.upper) - reach(next.lower);
    if (growth <= 0.0) { // smaller values only cross more
      weights.add(next.lower, reach(next.lower));
      weights.add(next.upper, -reach(next.upper));
      follow(segment, true, -growth, weights);
      return false;
    }
    node.most = {node.most.value - crossing / growth, Origin::Pair, next.lower, next.upper};
    if (node.most.value < node.least.value) {
      follow(segment, true, 1.0, weights);
      follow(segment, false, 1.0, weights);
      return false;
    }
  }
}

bool MinimaxChain::narrowFromBelow(std::size_t segment, double error, Weights& weights) {
  Interval& node = m_node[segment];
  for (;;) {
    const Extremes next = nextNode(segment, node.least.value, error);
    const double crossing = next.least - next.most;
    const bool samePair =
        node.least.origin == Origin::Pair && node.least.lower == next.lower && node.least.upper == next.upper;
    if (crossing <= 0.0 || samePair) {
      return true;
    }
    const double growth = reach(next.lower) - reach(next.upper);
    if (growth <= 0.0) {
      weights.add(next.lower, reach(next.lower));
      weights.add(next.upper, -reach(next.upper));
      follow(segment, false, -growth, weights);
      return false;
    }
    node.least = {node.least.value + crossing / growth, Origin::Pair, next.lower, next.upper};
    if (node.least.value > node.most.value) {
      follow(segment, true, 1.0, weights);
      follow(segment, false, 1.0, weights);
      return false;
    }
  }
}

/// Adds the samples behind a bound, back along the chain to where it starts.
void MinimaxChain::follow(std::size_t node, bool upperSide, double multiplier, Weights& weights) const {
  for (;;) {
    if (multiplier > overflowGuard) {
      weights.scale(1.0 / multiplier);
      multiplier = 1.0;
    }
    const Bound& bound = upperSide ? m_node[node].most : m_node[node].least;
    switch (bound.origin) {
    case Origin::First:
      return;
    case Origin::NodeSample:
      weights.add(upperSide ? bound.upper : bound.lower, upperSide ? -multiplier : multiplier);
      return;
    case Origin::Pair: {
      const double share = multiplier / std::abs(reach(bound.upper) - reach(bound.lower));
      weights.add(bound.lower, share * reach(bound.lower));
      weights.add(bound.upper, -share * reach(bound.upper));
      return;
    }
    case Origin::Chain: {
      const int sample = upperSide ? bound.upper : bound.lower;
      weights.add(sample, (upperSide ? -multiplier : multiplier) * reach(sample));
      multiplier *= reach(sample) - 1.0;
      upperSide = !upperSide;
      --node;
      break;
    }
    }
  }
}

MinimaxCut MinimaxChain::cutFrom(const Weights& weights) const {
  MinimaxCut cut;
  cut.weight = weights.value;
  double sum = 0.0;
  for (const double weight : cut.weight) {
    sum += std::abs(weight);
  }
  const auto lastSegment = static_cast<std::size_t>(m_begin[m_size - 1]);
  const auto firstSegmentEnd = static_cast<std::size_t>(m_begin[1]);
  for (std::size_t i = 0; i < cut.weight.size(); ++i) {
    cut.weight[i] /= sum;
    cut.constant += cut.weight[i] * (*m_curve)[static_cast<Eigen::Index>(i)];
    if (i < firstSegmentEnd) {
      cut.slope -= cut.weight[i] * (1.0 - m_fraction[i]);
    }
    if (i >= lastSegment) {
      cut.slope -= cut.weight[i] * m_fraction[i];
    }
  }
  return cut;
}

std::optional<MinimaxCut> MinimaxChain::obstacle(double first, double error) {
  Weights weights(m_fraction.size());
  m_node[0] = {{first, Origin::First, -1, -1}, {first, Origin::First, -1, -1}};
  for (std::size_t k = 0; k < m_size; ++k) {
    if (!clipToNodeSample(k, error)) {
      follow(k, true, 1.0, weights);
      follow(k, false, 1.0, weights);
      return cutFrom(weights);
    }
    if (!narrowFromAbove(k, error, weights) || !narrowFromBelow(k, error, weights)) {
      return cutFrom(weights);
    }
    const Extremes fromMost = nextNode(k, m_node[k].most.value, error);
    const Extremes fromLeast = nextNode(k, m_node[k].least.value, error);
    m_node[k + 1].least = {fromMost.least, Origin::Chain, fromMost.lower, -1};
    m_node[k + 1].most = {fromLeast.most, Origin::Chain, -1, fromLeast.upper};
  }
  const bool tooHigh = first > m_node[m_size].most.value;
  if (tooHigh || first < m_node[m_size].least.value) {
    follow(m_size, tooHigh, 1.0, weights);
    return cutFrom(weights);
  }
  return std::nullopt;
}

Eigen::VectorXd MinimaxChain::polygon(double first, double error, const Eigen::VectorXd& wished) const {
  Eigen::VectorXd values(static_cast<Eigen::Index>(m_size));
  values[0] = first;
  double next = first;
  for (std::size_t k = m_size - 1; k > 0; --k) {
    double least = m_node[k].least.value;
    double most = m_node[k].most.value;
    for (int i = m_begin[k]; i < m_begin[k + 1]; ++i) {
      const double fraction = m_fraction[static_cast<std::size_t>(i)];
      const double middle = (*m_curve)[i] - fraction * next;
      least = std::max(least, (middle - error) / (1.0 - fraction));
      most = std::min(most, (middle + error) / (1.0 - fraction));
    }
    const auto at = static_cast<Eigen::Index>(k);
    // Away from the ends: a value on the end of its interval pins the next one to a point, and a chain of such points
    // multiplies rounding. Where the interval is a single point, rounding may have turned its ends around.
    const double inset = 0.25 * (most - least);
    values[at] = inset > 0.0 ? std::clamp(wished[at], least + inset, most - inset) : 0.5 * (least + most);
    next = values[at];
  }
  return values;
}

} // namespace straightedge::angle
