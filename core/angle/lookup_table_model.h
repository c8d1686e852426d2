// Lookup tables: SIZE equal bins over the turn, one value each.
#pragma once

#include "core/angle/model_name.h"

#include <Eigen/Core>

#include <span>

namespace straightedge::angle {

/// Mean of the curve in each bin (least rms error), or the middle between its smallest and largest value there (least
/// maximum error that these bins allow). `gridDeg` is the curve at i·360/4096; sample i belongs to bin ⌊i·size/4096⌋.
Eigen::VectorXd lookupTableValues(const Eigen::VectorXd& gridDeg, int size, FitMethod method);

/// Model at i·360/count into out[0 … count).
void evaluateLookupTable(std::span<const double> valuesDeg, double* out, int count);

double lookupTableAt(std::span<const double> valuesDeg, double readingDeg);

} // namespace straightedge::angle
