#include "core/field/closest_fit.h"

#include "core/field/joint_weights.h"
#include "core/numerics/polynomial.h"

#include <algorithm>
#include <limits>
#include <map>

namespace straightedge::field {

namespace {

constexpr std::size_t cubic = 4; ///< coefficients

/// Fields of the sweeps over the probe's temperature.
std::size_t sweptFields(const std::vector<FitPoint>& points) {
  std::map<std::size_t, int> runs;
  for (const FitPoint& point : points) {
    if (point.step == CampaignStep::Sensitivity) {
      ++runs[point.run];
    }
  }
  return runs.size();
}

} // namespace

int closestOrder(const std::vector<FitPoint>& points, std::size_t axis, int lowest) {
  const RowNoise noise = rowNoise(points, axis);
  std::vector<double> raw;
  std::vector<double> target;
  std::vector<double> variance;
  for (const FitPoint& point : points) {
    if (point.step == CampaignStep::Nonlinearity) {
      raw.push_back(point.rawT);
      target.push_back(point.targetT);
      variance.push_back(noise.varianceT2(point.targetT) / static_cast<double>(point.rows));
    }
  }
  const auto count = static_cast<Eigen::Index>(raw.size());
  const Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(raw.data(), count);
  const Eigen::VectorXd y = Eigen::Map<const Eigen::VectorXd>(target.data(), count);
  const Eigen::ArrayXd variances = Eigen::Map<const Eigen::ArrayXd>(variance.data(), count);
  constexpr int freedomKept = 4;
  const int highest = std::min(highestClosestOrder, static_cast<int>(count) - 1 - freedomKept);
  int best = lowest;
  double least = std::numeric_limits<double>::infinity();
  for (int order = lowest; order <= highest && count > 0 && variances.minCoeff() > 0.0; ++order) {
    const auto fit = numerics::fitPolynomial(x, y, order, numerics::PolynomialDetail::WithoutInfluence);
    if (!fit) {
      break;
    }
    const double expected = (fit->residuals.array().square() / variances).sum() + 2.0 * (order + 1);
    if (expected < least) {
      least = expected;
      best = order;
    }
  }
  return best;
}

Result<JointReport> fitClosely(const FitPoints& points, const CorrectionChain& start, const std::string& name) {
  CorrectionChain rich = start;
  for (std::size_t axis = 0; axis < rich.axes.size(); ++axis) {
    AxisChain& blocks = rich.axes[axis];
    const std::vector<FitPoint>& of = points.axes[axis];
    if (!blocks.nonlinearity.empty()) {
      const int order = closestOrder(of, axis, std::max(1, static_cast<int>(blocks.nonlinearity.size()) - 1));
      blocks.nonlinearity.resize(static_cast<std::size_t>(order) + 1, 0.0);
    }
    if (blocks.sensitivitySlope) {
      const std::size_t terms = std::max(blocks.sensitivitySlope->size(), std::min(cubic, sweptFields(of)));
      blocks.sensitivitySlope->resize(terms, 0.0);
    }
  }
  return fitJointly(points, rich, {.weights = JointWeights::Noise}, name);
}

} // namespace straightedge::field
