#include "core/angle/calibration.h"

#include "core/angle/messages.h"
#include "core/base/number_text.h"

#include <algorithm>

namespace straightedge::angle {

std::vector<Warning> modelWarnings(const Model& model, const AlignedSweep& aligned, const CorrectionCurve& curve) {
  std::vector<Warning> warnings;
  const std::string name = model.name.text();
  const auto points = static_cast<int>(aligned.distinctAngles);
  if (model.name.kind == ModelKind::Linear && points < model.name.size) {
    warnings.push_back({Warning::Topic::FewerPointsThanSegments,
                        name + " has more segments than there are distinct angles, " + std::to_string(points) +
                            ": record at least as many angles as segments, better twice as many."});
  }
  if (model.name.kind == ModelKind::Harmonic && curve.method == CurveMethod::Regress &&
      model.name.size > curve.harmonics) {
    warnings.push_back({Warning::Topic::BeyondData, name + " asks for more harmonics than the " +
                                                        std::to_string(curve.harmonics) +
                                                        " that cross-validation found in the data: the others are 0."});
  }
  if (model.errors.maxCurveDeg < curve.leaveOneOutRmsDeg) {
    warnings.push_back({Warning::Topic::NoisyForModel,
                        name + " follows the correction curve to within " + degreesText(model.errors.maxCurveDeg) +
                            ", but the points foretell one another only to " + degreesText(curve.leaveOneOutRmsDeg) +
                            " (rms, leave-one-out): the model is more accurate than the data, which support no claim "
                            "below about " +
                            formatForPeople(curve.leaveOneOutRmsDeg, 1) + "°."});
  }
  return warnings;
}

Result<CalibrationRun> calibrate(const Sweep& sweep, const CalibrationOptions& options,
                                 const Traceability& traceability) {
  auto aligned = alignSweep(sweep);
  if (!aligned) {
    return std::unexpected(std::move(aligned.error()));
  }
  auto curve = fitCurve(*aligned, options.curve);
  if (!curve) {
    curve.error().where = sweep.source.file;
    return std::unexpected(std::move(curve.error()));
  }
  CalibrationRun run{std::move(*aligned), std::move(*curve), {}};
  AngleCalibration& result = run.result;
  result.software = "straightedge " STRAIGHTEDGE_VERSION;
  result.source = sweep.source;
  result.source.points = run.aligned.readingDeg.size();
  result.traceability = traceability;
  result.direction = run.aligned.direction;
  result.curveMethod = run.curve.method;
  result.curveHarmonics = run.curve.harmonics;
  result.leaveOneOutRmsDeg = run.curve.leaveOneOutRmsDeg;
  result.leaveOneOutMaxDeg = run.curve.leaveOneOutMaxDeg;
  result.passes = run.aligned.passes;
  result.gaps = run.aligned.gaps;
  result.warnings = run.aligned.warnings;

  UncertaintyInputs inputs;
  inputs.referenceExpandedDeg = traceability.reference.uncertainty;
  for (const ModelName& name : options.models) {
    auto model = fitModel(run.curve, name);
    if (!model) {
      if (model.error().where.empty()) {
        model.error().where = sweep.source.file;
      }
      return std::unexpected(std::move(model.error()));
    }
    measurePoints(*model, run.aligned);
    result.uncertainty.push_back(uncertaintyOf(*model, run.aligned, run.curve, inputs));
    for (Warning& warning : modelWarnings(*model, run.aligned, run.curve)) {
      result.warnings.push_back(std::move(warning));
    }
    result.models.push_back(std::move(*model));
  }
  return run;
}

} // namespace straightedge::angle
