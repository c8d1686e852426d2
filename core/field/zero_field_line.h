// Offset of one axis over a temperature, in a zero-field chamber: over the probe's temperature (Electronics 2020, 9,
// 151, section 5.2.2, Figure 8) and over the electronics' temperature (section 5.2.4, Figure 18).
#pragma once

#include "core/base/error.h"
#include "core/field/block_report.h"
#include "core/field/calibration.h"
#include "core/field/step_rows.h"

#include <Eigen/Core>

#include <array>
#include <string>

namespace straightedge::field {

struct ZeroFieldReport {
  Axis axis = Axis::X;
  BlockReport block;                        ///< residuals in tesla
  std::array<double, 2> offsetT = {0., 0.}; ///< tesla, tesla per °C from the reference temperature
  double spanC = 0.0;                       ///< temperatures covered
  Eigen::VectorXd temperatureC, valueT;     ///< for the plot: minus reference temperature; before this block
};

/// AxisChain::offsetT: a line through V1 over probe temperature. `chain` holds pt100 and nonlinearity.
/// Errors (Input): too few rows; a temperature that does not move; a field that is not zero.
Result<ZeroFieldReport> fitTemperatureOffset(const StepRows& rows, const CorrectionChain& chain, Axis axis,
                                             const std::string& name);

/// AxisChain::electronicsT: a line through V3 over electronics temperature. `chain` holds the blocks before.
/// Errors: the same.
Result<ZeroFieldReport> fitElectronicsOffset(const StepRows& rows, const CorrectionChain& chain, Axis axis,
                                             const std::string& name);

} // namespace straightedge::field
