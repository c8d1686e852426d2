// What a field calibration leaves: the coefficients of the chain from raw readings to field, and how good they are.
#pragma once

#include "core/base/traceability.h"
#include "core/field/campaign.h"
#include "core/field/uncertainty_summary.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
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

enum class FitMethod : std::uint8_t {
  Stepwise, ///< block after block, each on what the ones before leave (the paper's way)
  Joint,    ///< all blocks refined together
};

/// The blocks of the chain in its order.
enum class Block : std::uint8_t {
  Nonlinearity,
  ProbeTemperature,
  Offset,
  Sensitivity,
  Electronics,
  ElectronicsSensitivity,
  AxisMatrix,
};

/// How one block was made, for certificates and the stage table.
struct BlockSummary {
  Block block = Block::Nonlinearity;
  std::optional<Axis> axis; ///< of a block per axis
  std::string how;
  std::size_t rowsUsed = 0;
  std::size_t rowsLeftOut = 0;
  std::size_t coefficients = 0;
  double residualSigma = 0.0; ///< in the block's unit: tesla, °C for the probe's temperature
  double residualLargest = 0.0;
};

/// A block that is off, or less than it could be: why, and what that costs.
struct FieldWarning {
  Block block = Block::Nonlinearity;
  std::string text; ///< whole sentences
};

/// One order of an axis's nonlinearity. Percent of full scale.
struct OrderError {
  Axis axis = Axis::X;
  int order = 0;
  double maxErrorPercent = 0.0;
  std::optional<double> crossMaxPercent, crossRmsPercent; ///< plateaus foretold by fits to the others
};

/// instrument − reference over the rows of one axis, percent.
struct ErrorFigures {
  double mean = 0.0;
  double sigma = 0.0; ///< √(Σ(error − mean)²/n)
  double peak = 0.0;  ///< magnitude
};

/// How far the chain has been applied. Calibrated is the axis's own chain, V5; AxisMatrix the field along the axis
/// after the matrix, B.
enum class VerifiedState : std::uint8_t {
  Uncalibrated,
  Nonlinearity,
  Offset,
  Sensitivity,
  Electronics,
  ElectronicsSensitivity,
  Calibrated,
  AxisMatrix,
};

struct VerificationRow {
  Axis axis = Axis::X;
  VerifiedState state = VerifiedState::Uncalibrated;
  ErrorFigures ofFullScale;
  std::optional<ErrorFigures> ofReading; ///< over readings in at least 5 % of full scale; nothing without any
  std::size_t points = 0;                ///< 0 where not known (read from a file of others)
};

/// What is known of the PT100's line beside the line.
struct ProbeQuality {
  double standardUncertaintyC = 0.0;
  std::optional<double> hysteresisC;
  std::optional<double> lagS;
  std::string lagText;
};

/// What calibration.json holds of a field calibration.
struct FieldCalibration {
  std::string created;  ///< ISO 8601 UTC
  std::string software; ///< "straightedge X.Y.Z"
  SourceRecord source;
  Traceability traceability;
  CorrectionChain chain;
  std::vector<OrderError> orders;
  std::vector<VerificationRow> verification;     ///< empty where the campaign has no verification rows
  std::optional<UncertaintySummary> uncertainty; ///< nothing where the campaign does not bear one
  // How it was made
  FitMethod method = FitMethod::Stepwise;
  std::string jointHow;                              ///< of a joint fit: one sentence
  std::vector<VerificationRow> stepwiseVerification; ///< of a joint fit: what the fit it started from had left
  int order = 5;                                     ///< of the nonlinearity
  std::array<std::string, 3> orderExplanation;
  std::vector<BlockSummary> blocks;
  std::optional<ProbeQuality> probe;
  std::vector<FieldWarning> warnings;
};

} // namespace straightedge::field
