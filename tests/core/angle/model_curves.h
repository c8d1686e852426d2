// Correction curves that the tests of models share.
#pragma once

#include "core/angle/curve.h"

#include <cstdint>
#include <string>
#include <vector>

namespace straightedge::angle {

/// A file in tests/data/angle.
std::string angleData(const std::string& name);

/// The 32 recorded points of tests/data/angle/side_shaft_32.csv, aligned, and the curve through them.
const AlignedSweep& sideShaftAligned();
const CorrectionCurve& sideShaftCurve();
/// The same curve with 64 harmonics to choose from, as in the study that tests/data/angle/side_shaft_32_storage.csv
/// comes from (32 points resolve 16).
const CorrectionCurve& studiedCurve();

/// offset + Σ amplitude·cos(order·x + phase), 64 harmonics resolved.
struct Wave {
  int order;
  double amplitudeDeg;
  double phaseRad;
};
CorrectionCurve curveOfWaves(double offsetDeg, const std::vector<Wave>& waves);

/// Any values on the grid; sampled() and at() do not know them.
CorrectionCurve curveOfGrid(const Eigen::VectorXd& gridDeg);

/// Repeatable rough grids: smooth waves, noise, steps and spikes, chosen by `seed`.
Eigen::VectorXd roughGrid(std::uint32_t seed);

} // namespace straightedge::angle
