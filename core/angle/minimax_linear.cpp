#include "core/angle/minimax_linear.h"

#include "core/angle/linear_model.h"
#include "core/angle/minimax_chain.h"
#include "core/angle/residual_errors.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <span>

namespace straightedge::angle {

namespace {

/// Least error that all cuts allow, over the value at node 0: where a falling and a rising one meet, or the highest
/// level one together with the range of values that the others leave.
class CutBounds {
public:
  explicit CutBounds(double nodeSample, std::size_t samples) {
    for (const double sign : {1.0, -1.0}) { // the sample on node 0 itself: error ≥ |sample − value|
      MinimaxCut cut{sign * nodeSample, -sign, std::vector<double>(samples, 0.0)};
      cut.weight[0] = sign;
      m_cuts.push_back(std::move(cut));
    }
  }

  void add(MinimaxCut cut) { m_cuts.push_back(std::move(cut)); }

  void solve(double wished) {
    std::size_t falling = 0;
    std::size_t rising = 1;
    double error = 0.0;
    for (;;) {
      const MinimaxCut& f = m_cuts[falling];
      const MinimaxCut& r = m_cuts[rising];
      m_first = (f.constant - r.constant) / (r.slope - f.slope);
      error = f.constant + f.slope * m_first;
      const std::size_t highest = highestAt(m_first);
      if (highest == falling || highest == rising ||
          m_cuts[highest].constant + m_cuts[highest].slope * m_first <= error) {
        break;
      }
      (m_cuts[highest].slope < 0.0 ? falling : rising) = highest;
    }
    m_error = error;
    m_falling = falling;
    m_rising = rising;
    m_share = m_cuts[rising].slope / (m_cuts[rising].slope - m_cuts[falling].slope);
    const std::size_t level = highestLevel();
    if (level < m_cuts.size() && m_cuts[level].constant >= error) {
      m_error = m_cuts[level].constant;
      m_falling = m_rising = level;
      m_share = 1.0;
      m_first = valueNear(wished);
    }
  }

  double error() const { return m_error; }
  double first() const { return m_first; }

  /// The cuts that hold the bound up, combined so that node 0 cancels too.
  MinimaxProof proof(const Eigen::VectorXd& curve) const {
    MinimaxProof proof;
    for (std::size_t i = 0; i < m_cuts[m_falling].weight.size(); ++i) {
      const double weight = m_share * m_cuts[m_falling].weight[i] + (1.0 - m_share) * m_cuts[m_rising].weight[i];
      if (weight != 0.0) {
        proof.weights.push_back({static_cast<int>(i), weight});
        proof.lowerBoundDeg += weight * curve[static_cast<Eigen::Index>(i)];
      }
    }
    return proof;
  }

private:
  static constexpr double levelSlope = 1e-13;
  static bool isLevel(const MinimaxCut& cut) { return std::abs(cut.slope) < levelSlope; }

  std::size_t highestAt(double first) const {
    std::size_t highest = 0;
    double most = -std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < m_cuts.size(); ++j) {
      const double value = m_cuts[j].constant + m_cuts[j].slope * first;
      if (!isLevel(m_cuts[j]) && value > most) {
        most = value;
        highest = j;
      }
    }
    return highest;
  }

  std::size_t highestLevel() const {
    std::size_t highest = m_cuts.size();
    for (std::size_t j = 0; j < m_cuts.size(); ++j) {
      if (isLevel(m_cuts[j]) && (highest == m_cuts.size() || m_cuts[j].constant > m_cuts[highest].constant)) {
        highest = j;
      }
    }
    return highest;
  }

  double valueNear(double wished) const {
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();
    for (const MinimaxCut& cut : m_cuts) {
      if (!isLevel(cut)) {
        const double limit = (m_error - cut.constant) / cut.slope;
        (cut.slope < 0.0 ? least : most) = cut.slope < 0.0 ? std::max(least, limit) : std::min(most, limit);
      }
    }
    return least < most ? std::clamp(wished, least, most) : 0.5 * (least + most);
  }

  std::vector<MinimaxCut> m_cuts;
  std::size_t m_falling = 0;
  std::size_t m_rising = 1;
  double m_share = 0.5; ///< of the falling cut in the combination
  double m_error = 0.0;
  double m_first = 0.0;
};

double maxErrorOf(const Eigen::VectorXd& values, const Eigen::VectorXd& curve) {
  Eigen::VectorXd model(curve.size());
  evaluateLinear({values.data(), static_cast<std::size_t>(values.size())}, model.data(),
                 static_cast<int>(curve.size()));
  return residualErrors(model.data(), curve.data(), static_cast<std::size_t>(curve.size())).maxAbs;
}

} // namespace

Result<MinimaxLinear> linearMinimax(const Eigen::VectorXd& gridDeg, int size, const JobControl& job) {
  assert(size >= 2 && gridDeg.size() >= 2 * size && gridDeg.allFinite());
  // About its middle, so that rounding is relative to the swing; the offset is added at the end.
  const double middle = 0.5 * (gridDeg.maxCoeff() + gridDeg.minCoeff());
  const double swing = gridDeg.maxCoeff() - gridDeg.minCoeff();
  const Eigen::VectorXd curve = gridDeg.array() - middle;
  const Eigen::VectorXd wished = linearLeastSquares(curve, size);

  MinimaxChain chain(curve, size);
  CutBounds bounds(curve[0], static_cast<std::size_t>(curve.size()));
  double slack = 1e-14 * swing; // what rounding needs; grows where a cut brings no progress
  double before = -1.0;
  for (;;) {
    if (job.stopRequested()) {
      return fail(ErrorKind::Cancelled, "the minimax fit was stopped", "");
    }
    bounds.solve(wished[0]);
    const double tried = bounds.error() + slack;
    auto cut = chain.obstacle(bounds.first(), tried);
    if (!cut) {
      MinimaxLinear result;
      result.valuesDeg = chain.polygon(bounds.first(), tried, wished);
      result.maxErrorDeg = maxErrorOf(result.valuesDeg, curve);
      if (result.maxErrorDeg <= bounds.error() + 4.0 * slack) {
        result.valuesDeg.array() += middle;
        result.proof = bounds.proof(curve);
        return result;
      }
      slack *= 4.0;
      continue;
    }
    const bool progress = cut->constant + cut->slope * bounds.first() > tried && bounds.error() >= before;
    before = bounds.error();
    if (!progress) {
      slack *= 4.0;
    }
    bounds.add(std::move(*cut));
  }
}

} // namespace straightedge::angle
