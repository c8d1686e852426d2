// The whole angle calibration as one verb: sweep and options in, everything a file or a report says out.
#pragma once

#include "core/angle/model.h"
#include "core/angle/uncertainty.h"
#include "core/base/traceability.h"

#include <string>
#include <vector>

namespace straightedge::angle {

struct CalibrationOptions {
  std::vector<ModelName> models = defaultModels();
  CurveOptions curve;
};

/// What calibration.json holds of an angle calibration. Read back from a file, `curve` and `aligned` are not part of
/// it.
struct AngleCalibration {
  std::string created;  ///< ISO 8601 UTC
  std::string software; ///< "straightedge X.Y.Z"
  SourceRecord source;
  Traceability traceability;
  SensorDirection direction = SensorDirection::Increasing;
  std::vector<Model> models;
  std::vector<UncertaintyBudget> uncertainty; ///< one per model
  // How it was made
  CurveMethod curveMethod = CurveMethod::Interpolate;
  int curveHarmonics = 0;
  double leaveOneOutRmsDeg = 0.0;
  double leaveOneOutMaxDeg = 0.0;
  Repeatability passes;
  std::vector<CoverageGap> gaps;
  std::vector<Warning> warnings;
};

/// A calibration with the data it came from, for the window, plots and the report.
struct CalibrationRun {
  AlignedSweep aligned;
  CorrectionCurve curve;
  AngleCalibration result;
};

/// align -> curve -> models -> uncertainty. `created` is left for the caller, who knows the clock.
Result<CalibrationRun> calibrate(const Sweep& sweep, const CalibrationOptions& options,
                                 const Traceability& traceability);

/// Warnings that depend on a model: fewer points than segments, model more accurate than the data.
std::vector<Warning> modelWarnings(const Model& model, const AlignedSweep& aligned, const CorrectionCurve& curve);

} // namespace straightedge::angle
