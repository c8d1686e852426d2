// The sensor's output step as the readings themselves show it.
#pragma once

#include <Eigen/Core>

namespace straightedge::angle {

/// Largest usual step (360°/2^b for 6 to 20 bits, or a decimal place from 1° to 0.000001°) of which all distances
/// between readings are whole multiples; 0 where there is none. Independent of where the readings start.
double estimateResolutionDeg(const Eigen::VectorXd& readingDeg);

} // namespace straightedge::angle
