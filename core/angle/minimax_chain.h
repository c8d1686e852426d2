// Is there a closed polygon over equal segments that stays within a given distance of a curve? One step of the minimax
// fit.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace straightedge::angle {

/// Valid for every polygon: largest error ≥ constant + slope·(value at node 0). A combination of samples with signed
/// weights, Σ|weight| = 1, in which every node but node 0 cancels.
struct MinimaxCut {
  double constant = 0.0;
  double slope = 0.0;
  std::vector<double> weight; ///< one per sample of the grid
};

/// Holds the curve and the intervals of the last attempt. One thread at a time.
class MinimaxChain {
public:
  /// `curve` is sampled evenly over the turn; `size` segments, each with at least two samples.
  MinimaxChain(const Eigen::VectorXd& curve, int size);

  /// Tries the value `first` at node 0 within `error` of every sample. Nothing: it is possible, and polygon() builds
  /// one. Otherwise the inequality that forbids it.
  std::optional<MinimaxCut> obstacle(double first, double error);

  /// Node values of a polygon within `error` of the curve, as close to `wished` as that permits. After obstacle()
  /// found none for these.
  Eigen::VectorXd polygon(double first, double error, const Eigen::VectorXd& wished) const;

private:
  enum class Origin : unsigned char { First, NodeSample, Pair, Chain };

  /// A bound on a node's value and the samples it comes from.
  struct Bound {
    double value = 0.0;
    Origin origin = Origin::First;
    int lower = -1; ///< sample whose lower limit acts
    int upper = -1; ///< sample whose upper limit acts
  };
  struct Interval {
    Bound least, most;
  };
  struct Extremes { ///< of the next node's value, for one value at this node
    double least = 0.0;
    double most = 0.0;
    int lower = -1;
    int upper = -1;
  };
  struct Weights;

  Extremes nextNode(std::size_t segment, double value, double error) const;
  bool clipToNodeSample(std::size_t segment, double error);
  bool narrowFromAbove(std::size_t segment, double error, Weights& weights);
  bool narrowFromBelow(std::size_t segment, double error, Weights& weights);
  void follow(std::size_t node, bool upperSide, double multiplier, Weights& weights) const;
  MinimaxCut cutFrom(const Weights& weights) const;
  double reach(int sample) const { return m_reach[static_cast<std::size_t>(sample)]; }

  const Eigen::VectorXd* m_curve;
  std::size_t m_size;
  std::vector<int> m_begin;       ///< first sample of each segment, and the end
  std::vector<double> m_fraction; ///< how far each sample lies into its segment, [0, 1)
  std::vector<double> m_reach;    ///< 1/fraction; 0 for a sample on the node itself
  std::vector<Interval> m_node;   ///< size + 1: the last is node 0 again
};

} // namespace straightedge::angle
