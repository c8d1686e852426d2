// How much the points of a joint fit count, and how much single rows scatter.
#pragma once

#include "core/field/fit_points.h"

#include <Eigen/Core>

#include <vector>

namespace straightedge::field {

/// σ² of a single row's V5 at a field: constant² + (perTesla·field)²; the second part is what temperatures that are
/// read with noise make of the field.
struct RowNoise {
  double constantT = 0.0;
  double perTesla = 0.0;
  double varianceT2(double fieldT) const { return constantT * constantT + perTesla * perTesla * fieldT * fieldT; }
};

/// The field that a point's axis should show: its target, or in orientations its package axis's own share.
double ownFieldT(const FitPoint& point, std::size_t axis);

/// From the scatter of the rows within the points.
RowNoise rowNoise(const std::vector<FitPoint>& points, std::size_t axis);

/// JointWeights::EvenError: see there. The plateaus' mean weight is 1.
Eigen::VectorXd evenErrorWeights(const std::vector<FitPoint>& points);

/// JointWeights::Noise: rows over variance.
Eigen::VectorXd noiseWeights(const std::vector<FitPoint>& points, std::size_t axis, const RowNoise& noise);

} // namespace straightedge::field
