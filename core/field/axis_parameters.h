// The coefficients of one axis's chain as a vector of unknowns, and how its value depends on each of them.
#pragma once

#include "core/field/calibration.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace straightedge::field {

enum class ChainBlock : std::uint8_t {
  Nonlinearity,
  Offset,
  SensitivitySlope,
  SensitivityIntercept,
  Electronics,
  ElectronicsSensitivity,
};

struct ChainParameter {
  ChainBlock block = ChainBlock::Nonlinearity;
  std::size_t index = 0; ///< in the block's coefficients
};

double& valueOf(AxisChain& axis, const ChainParameter& parameter);

/// Several coefficients of the chain say the same: a constant may stand in four blocks, a factor in two, a change with
/// temperature in two each. A fit of all of them at once has no single answer unless one place is chosen. It is the
/// first block that has the term:
///   constant                   nonlinearity[0]; offset[0], intercept[0] and electronics[0] are 0
///   factor                     nonlinearity[1]; intercept[1] and above are 0
///   tesla per °C of the probe  offset[1]; slope[0] is 0 (it stays free where the offset is off)
///   tesla per °C of the electronics
///                              electronics[1]; es[0] is 0 (it stays free where the electronics' offset is off)
/// The chain at the reference temperatures is then the nonlinearity alone. The PT100's line is no unknown either: a
/// change of its slope or intercept is one of slope, offset and nonlinearity.
/// Gives the unknowns that are left, in the chain's order.
std::vector<ChainParameter> independentParameters(const AxisChain& axis);

/// The same correction, to first order, with every coefficient that is not independent at 0: where a fit starts.
AxisChain inIndependentParameters(const AxisChain& axis);

/// V5 of one axis, and how it changes.
struct AxisGradient {
  double valueT = 0.0;
  double byRaw = 0.0;         ///< 1
  double byProbe = 0.0;       ///< T/°C
  double byElectronics = 0.0; ///< T/°C
};

/// Fills `byParameter`, as long as `parameters`, with the derivatives by the unknowns.
AxisGradient axisGradient(const AxisChain& axis, const std::vector<ChainParameter>& parameters, double rawT,
                          double probeC, double electronicsC, Eigen::Ref<Eigen::VectorXd> byParameter);

} // namespace straightedge::field
