// What a field calibration leaves: the coefficients of the chain from raw readings to field, and how good they are.
#pragma once

#include "core/base/traceability.h"
#include "core/field/campaign.h"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace straightedge::field {

/// Polynomials in ascending powers. A block that is switched off is empty and corrects nothing.
struct AxisChain {
  std::vector<double> nonlinearity;                            ///< tesla of raw tesla
  std::optional<std::array<double, 2>> offsetT;                ///< tesla over probe temperature minus reference
  std::optional<std::vector<double>> sensitivitySlope;         ///< K: T/°C over tesla
  std::optional<std::vector<double>> sensitivityIntercept;     ///< C: T over tesla
  std::optional<std::array<double, 2>> electronicsT;           ///< tesla over electronics temperature minus reference
  std::optional<std::array<double, 2>> electronicsSensitivity; ///< [0] T/°C, [1] 1/°C
};

/// Probe temperature minus reference temperature, in °C, of the PT100's resistance.
struct Pt100Line {
  double slopeCPerOhm = 0.0;
  double interceptC = 0.0;
};

/// The chain, with R in ohms, E = electronics temperature − reference temperature (Hall teslameter calibration paper,
/// Electronics 2020, 9, 151, Figure 4 and sections 5.1 to 5.2.4 and 7, Equations 2 and 3; the electronics' sensitivity
/// is left open there):
///   T  = slope·R + intercept
///   V1 = nonlinearity(raw)
///   V2 = V1 − (offset[0] + offset[1]·T)
///   V3 = V2 − (K(V2)·T + C(V2))        error = instrument − reference, and the correction takes it away; the paper's
///                                       text subtracts the other way round where its definition says add
///   V4 = V3 − (electronics[0] + electronics[1]·E)
///   V5 = V4 − (es[0] + es[1]·V4)·E
///   B  = S⁻¹ · (V5 of x, y, z)
struct CorrectionChain {
  double fullScaleT = 2.0;
  double referenceTemperatureC = 24.0;
  std::optional<Pt100Line> pt100;
  std::array<AxisChain, 3> axes;             ///< x, y, z
  std::optional<Eigen::Matrix3d> axisMatrix; ///< S: rows are probe axes, columns package axes
};

} // namespace straightedge::field
