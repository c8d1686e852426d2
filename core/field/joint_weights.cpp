#include "core/field/joint_weights.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace straightedge::field {

namespace {

bool isPlateau(const FitPoint& point) { return point.step == CampaignStep::Nonlinearity; }

/// The angle on Chebyshev's circle that belongs to a plateau: from half way to its neighbour below to half way to the
/// one above.
double chebyshevShare(const std::vector<double>& fieldsT, double fieldT) {
  const double middle = 0.5 * (fieldsT.front() + fieldsT.back());
  const double half = 0.5 * (fieldsT.back() - fieldsT.front());
  const auto at = std::lower_bound(fieldsT.begin(), fieldsT.end(), fieldT);
  const double below = at == fieldsT.begin() ? fieldT : 0.5 * (*(at - 1) + fieldT);
  const double above = at == fieldsT.end() || at + 1 == fieldsT.end() ? fieldT : 0.5 * (*(at + 1) + fieldT);
  const auto angle = [&](double field) { return std::acos(std::clamp((field - middle) / half, -1.0, 1.0)); };
  return angle(below) - angle(above);
}

} // namespace

double ownFieldT(const FitPoint& point, std::size_t axis) {
  return point.targetT + point.fieldT[static_cast<Eigen::Index>(axis)];
}

RowNoise rowNoise(const std::vector<FitPoint>& points, std::size_t axis) {
  double constant = 0.0;
  double square = 0.0;
  double freedom = 0.0;
  for (const FitPoint& point : points) {
    constant += point.scatterT2;
    freedom += static_cast<double>(point.rows - 1);
  }
  constant = freedom > 0.0 ? constant / freedom : 0.0;
  // A line through the points' variances over field², weighted by what each variance is worth: 2σ⁴/freedom.
  for (int pass = 0; pass < 4 && constant > 0.0; ++pass) {
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    for (const FitPoint& point : points) {
      if (point.rows < 2) {
        continue;
      }
      const double field = ownFieldT(point, axis);
      const double expected = constant + square * field * field;
      const double worth = static_cast<double>(point.rows - 1) / (expected * expected);
      const Eigen::Vector2d by(1.0, field * field);
      normal += worth * by * by.transpose();
      right += worth * by * point.scatterT2 / static_cast<double>(point.rows - 1);
    }
    const double determinant = normal(0, 0) * normal(1, 1) - normal(0, 1) * normal(1, 0);
    const double slope = (normal(0, 0) * right[1] - normal(1, 0) * right[0]) / determinant;
    const double level = (right[0] - slope * normal(0, 1)) / normal(0, 0);
    if (!(determinant > 0.0) || !(slope > 0.0) || !(level > 0.0)) {
      constant = right[0] / normal(0, 0); // without a part that grows with the field
      square = 0.0;
      break;
    }
    constant = level;
    square = slope;
  }
  return {std::sqrt(constant), std::sqrt(square)};
}

Eigen::VectorXd evenErrorWeights(const std::vector<FitPoint>& points) {
  std::vector<double> fieldsT;
  std::map<std::size_t, double> pointsOfRun;
  double plateaus = 0.0;
  for (const FitPoint& point : points) {
    pointsOfRun[point.run] += 1.0;
    if (isPlateau(point)) {
      fieldsT.push_back(point.targetT);
      plateaus += 1.0;
    }
  }
  std::sort(fieldsT.begin(), fieldsT.end());
  const bool spread = fieldsT.size() > 2 && fieldsT.back() > fieldsT.front();
  Eigen::VectorXd weights(static_cast<Eigen::Index>(points.size()));
  double total = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool shared = spread && isPlateau(points[i]);
    const double share = shared ? chebyshevShare(fieldsT, points[i].targetT) : 1.0;
    total += shared ? share : 0.0;
    weights[static_cast<Eigen::Index>(i)] = share;
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    double& weight = weights[static_cast<Eigen::Index>(i)];
    weight = spread && isPlateau(points[i]) ? weight * plateaus / total : weight / pointsOfRun[points[i].run];
  }
  return weights;
}

Eigen::VectorXd noiseWeights(const std::vector<FitPoint>& points, std::size_t axis, const RowNoise& noise) {
  Eigen::VectorXd weights(static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double variance = noise.varianceT2(ownFieldT(points[i], axis));
    weights[static_cast<Eigen::Index>(i)] = static_cast<double>(points[i].rows) / (variance > 0.0 ? variance : 1.0);
  }
  return weights;
}

} // namespace straightedge::field
