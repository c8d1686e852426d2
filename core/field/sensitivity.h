// How the sensitivity of one axis follows the probe's temperature: the error against temperature is a line at every
// locked field; its slope K is a cubic, its intercept C a line over the field (Electronics 2020, 9, 151, section
// 5.2.3, Figures 10 to 17, Table 2). And the same for the electronics' temperature, which the paper leaves for later
// (section 5.2.4).
//
// Error is instrument − reference, and the correction takes it away. The paper plots reference − instrument ("by
// subtracting the linearized values from the NMR readings") and then says that this error is subtracted, which would
// double it; the definition here is the one that its own Table 2 shows to work.
#pragma once

#include "core/base/error.h"
#include "core/field/block_report.h"
#include "core/field/calibration.h"
#include "core/field/step_rows.h"

#include <Eigen/Core>

#include <array>
#include <string>
#include <vector>

namespace straightedge::field {

inline constexpr int highestSlopeOrder = 3; ///< of the slope over the field: a cubic

/// Temperature swept at one field: error = intercept + slope·temperature.
struct FieldSweep {
  double referenceT = 0.0; ///< mean
  double valueT = 0.0;     ///< mean of the axis before the block: where the polynomials over the field are read
  double slope = 0.0;      ///< T/°C
  double intercept = 0.0;  ///< T, at the reference temperature
  double slopeSigma = 0.0; ///< standard uncertainties from the scatter about the line
  double interceptSigma = 0.0;
  double covariance = 0.0; ///< of slope and intercept
  double noiseT = 0.0;     ///< scatter about the line
  double spanC = 0.0;
  double meanErrorT = 0.0;      ///< instrument − reference before the block
  double meanErrorAfterT = 0.0; ///< and after it: Table 2
  Eigen::Index first = 0, rows = 0;
  std::int64_t line = 0;
};

/// One order of the polynomial through the slopes, side by side (Figure 16).
struct SlopeOrder {
  int order = 0;
  std::vector<double> coefficients;
  double rmsSlope = 0.0; ///< what it leaves of the slopes, T/°C
  double maxSlope = 0.0;
};

struct SensitivityReport {
  Axis axis = Axis::X;
  BlockReport block;         ///< residuals in tesla over all rows; covariance: slope's coefficients, then intercept's
  std::vector<double> slope; ///< K: T/°C over tesla
  std::vector<double> intercept; ///< C: T over tesla
  std::vector<FieldSweep> sweeps;
  std::vector<SlopeOrder> slopeOrders;
  std::string note; ///< a lower order than cubic, and why; else empty
};

/// AxisChain::sensitivitySlope and sensitivityIntercept from V2. `chain` holds the blocks before. The slope's order is
/// 3 or what the number of fields determines. Errors (Input): fewer than two fields with enough rows; a temperature
/// that does not move; fields of one sign only.
Result<SensitivityReport> fitSensitivity(const StepRows& rows, const CorrectionChain& chain, Axis axis,
                                         const std::string& name);

struct ElectronicsSensitivityReport {
  Axis axis = Axis::X;
  BlockReport block;                             ///< residuals in tesla over all rows
  std::array<double, 2> coefficients = {0., 0.}; ///< T/°C, 1/°C
  std::vector<FieldSweep> sweeps;
};

/// AxisChain::electronicsSensitivity: a line over V4 through the slopes of the error against electronics temperature.
/// Errors (Input): those of fitSensitivity.
Result<ElectronicsSensitivityReport> fitElectronicsSensitivity(const StepRows& rows, const CorrectionChain& chain,
                                                               Axis axis, const std::string& name);

} // namespace straightedge::field
