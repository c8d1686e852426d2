// The whole field calibration as one verb: campaign and options in, everything a file, a plot or a report says out.
#pragma once

#include "core/base/error.h"
#include "core/base/traceability.h"
#include "core/field/axis_matrix.h"
#include "core/field/calibration.h"
#include "core/field/joint_fit.h"
#include "core/field/nonlinearity.h"
#include "core/field/probe_temperature.h"
#include "core/field/sensitivity.h"
#include "core/field/step_rows.h"
#include "core/field/verification.h"
#include "core/field/zero_field_line.h"

#include <array>
#include <optional>

namespace straightedge::field {

struct FieldFitOptions {
  int order = defaultOrder; ///< of the nonlinearity, lowestOrder to highestOrder
  FitMethod method = FitMethod::Stepwise;
  double fullScaleT = 2.0;
  double referenceTemperatureC = 24.0;
};

/// What every block says of itself; nothing for a block that is off.
struct FieldReports {
  std::array<std::optional<NonlinearityReport>, 3> nonlinearity;
  std::optional<ProbeTemperatureReport> probeTemperature;
  std::array<std::optional<ZeroFieldReport>, 3> offset;
  std::array<std::optional<SensitivityReport>, 3> sensitivity;
  std::array<std::optional<ZeroFieldReport>, 3> electronics;
  std::array<std::optional<ElectronicsSensitivityReport>, 3> electronicsSensitivity;
  std::optional<AxisMatrixReport> axisMatrix;
};

/// A calibration with the data it came from, for the window, plots and the report.
struct FieldRun {
  CampaignParts parts;
  FieldReports reports; ///< of the fit step by step, whatever the method
  FieldVerification verification;
  FieldCalibration result;
  /// Of the method joint: how it went, and what the fit step by step that it started from is and leaves.
  struct Joint {
    JointReport report;
    CorrectionChain stepwiseChain;
    FieldVerification stepwiseVerification;
  };
  std::optional<Joint> joint;
};

/// Plateaus, then block after block in the chain's order, each on what the ones before leave, then the verification.
/// A step that is missing or cannot be used switches its block off, with a warning that says what it costs. `created`
/// is left for the caller, who knows the clock. Errors (Input, where = the campaign's name and line): a nonlinearity
/// that was recorded but cannot be used, since everything rests on it (fitNonlinearity); no step that can be used at
/// all; of the method joint those of fitJointly().
Result<FieldRun> calibrateField(const Campaign& campaign, const FieldFitOptions& options,
                                const Traceability& traceability);

} // namespace straightedge::field
