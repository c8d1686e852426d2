// What the instrument does as far as a campaign can tell: the chain with as many powers as the data bear, fitted with
// the weights of the noise. Nobody stores it in a microcontroller; it is what a chain of few coefficients is measured
// by, and free of the trade-offs of one.
#pragma once

#include "core/field/joint_fit.h"

#include <vector>

namespace straightedge::field {

inline constexpr int highestClosestOrder = 13;

/// The order of the nonlinearity with the least expected squared error of prediction over the plateaus, from `lowest`
/// up: Σ (residual/noise)² + 2·coefficients (Mallows 1973, Technometrics 15, 661).
int closestOrder(const std::vector<FitPoint>& points, std::size_t axis, int lowest);

/// `start` with the nonlinearity's orders raised to closestOrder() and the sensitivity's slope to a cubic where the
/// sweeps' fields determine one. Errors: those of fitJointly().
Result<JointReport> fitClosely(const FitPoints& points, const CorrectionChain& start, const std::string& name);

} // namespace straightedge::field
