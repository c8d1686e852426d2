#include "core/base/json_writer.h"
#include "core/export/calibration_head.h"
#include "core/export/calibration_json.h"
#include "core/export/calibration_words.h"

namespace straightedge::exporting {

namespace {

using namespace angle;

void writeErrors(JsonWriter& json, std::string_view name, double curve, double points) {
  json.openObject(name, true);
  json.member("curve", curve);
  json.member("points", points);
  json.endObject();
}

void writeValues(JsonWriter& json, const Eigen::VectorXd& values) {
  json.openList("values_deg", true);
  for (const double value : values) {
    json.value(value);
  }
  json.endList();
}

void writeHarmonics(JsonWriter& json, const HarmonicModel& model) {
  json.member("offset_deg", model.offsetDeg);
  json.openList("harmonics");
  for (const HarmonicTerm& term : model.terms) {
    json.beginObject(true);
    json.member("order", term.order);
    json.member("amplitude_deg", term.amplitudeDeg);
    json.member("phase_rad", term.phaseRad);
    json.endObject();
  }
  json.endList();
}

void writeStored(JsonWriter& json, const StoredIntegers& stored) {
  json.openObject("stored");
  json.member("bits", stored.bits);
  json.member("lsb_deg", stored.lsbDeg);
  if (stored.phaseLsbRad) {
    json.member("phase_lsb_rad", *stored.phaseLsbRad);
  }
  json.member("bias_deg", stored.biasDeg);
  json.member("signed", true);
  json.openList("integers", true);
  for (const int integer : stored.integers) {
    json.value(integer);
  }
  json.endList();
  json.endObject();
}

void writeModel(JsonWriter& json, const Model& model) {
  json.beginObject();
  json.member("name", model.name.text());
  json.member("storage_entries", model.name.storageEntries());
  writeErrors(json, "max_error_deg", model.errors.maxCurveDeg, model.errors.maxPointsDeg);
  writeErrors(json, "rms_error_deg", model.errors.rmsCurveDeg, model.errors.rmsPointsDeg);
  if (const auto* harmonic = std::get_if<HarmonicModel>(&model.body)) {
    writeHarmonics(json, *harmonic);
  } else if (const auto* linear = std::get_if<LinearModel>(&model.body)) {
    writeValues(json, linear->valuesDeg);
  } else if (const auto* table = std::get_if<LookupTableModel>(&model.body)) {
    writeValues(json, table->valuesDeg);
  }
  if (model.stored) {
    writeStored(json, *model.stored);
  }
  json.endObject();
}

void writeUncertainty(JsonWriter& json, const std::vector<UncertaintyBudget>& budgets) {
  if (budgets.empty()) {
    return;
  }
  json.openList("uncertainty");
  for (const UncertaintyBudget& budget : budgets) {
    json.beginObject();
    json.member("model", budget.model);
    json.member("expanded_deg", budget.expandedDeg);
    json.member("coverage_factor", budget.coverageFactor);
    json.member("combined_deg", budget.combinedDeg);
    json.openList("contributions");
    for (const UncertaintyContribution& contribution : budget.contributions) {
      json.beginObject(true);
      json.member("name", contribution.name);
      json.member("standard_deg", contribution.standardDeg);
      json.member("basis", contribution.basis);
      json.endObject();
    }
    json.endList();
    json.endObject();
  }
  json.endList();
}

void writeRepeatability(JsonWriter& json, const Repeatability& passes) {
  json.openObject("repeatability");
  json.member("turns", passes.turns);
  json.member("both_directions", passes.bothDirections);
  const auto optional = [&json](std::string_view name, const std::optional<double>& value) {
    if (value) {
      json.member(name, *value);
    }
  };
  optional("noise_deg", passes.noiseDeg);
  optional("repeatability_deg", passes.repeatabilityDeg);
  optional("hysteresis_max_deg", passes.hysteresisMaxDeg);
  optional("hysteresis_rms_deg", passes.hysteresisRmsDeg);
  json.endObject();
}

void writeCurve(JsonWriter& json, const AngleCalibration& calibration) {
  json.openObject("curve");
  json.member("method", wordOf(curveWords, calibration.curveMethod));
  if (calibration.curveMethod == CurveMethod::Regress) {
    json.member("harmonics", calibration.curveHarmonics);
  }
  json.member("leave_one_out_rms_deg", calibration.leaveOneOutRmsDeg);
  json.member("leave_one_out_max_deg", calibration.leaveOneOutMaxDeg);
  json.endObject();
}

void writeFindings(JsonWriter& json, const AngleCalibration& calibration) {
  if (!calibration.gaps.empty()) {
    json.openList("gaps");
    for (const CoverageGap& gap : calibration.gaps) {
      json.beginObject(true);
      json.member("from_deg", gap.fromDeg);
      json.member("width_deg", gap.widthDeg);
      json.endObject();
    }
    json.endList();
  }
  if (!calibration.warnings.empty()) {
    json.openList("warnings");
    for (const Warning& warning : calibration.warnings) {
      json.beginObject(true);
      json.member("topic", wordOf(topicWords, warning.topic));
      json.member("text", warning.text);
      json.endObject();
    }
    json.endList();
  }
}

} // namespace

std::string calibrationToJson(const AngleCalibration& calibration) {
  JsonWriter json;
  json.beginObject();
  writeCalibrationHead(json, "angle",
                       {calibration.created, calibration.software, calibration.source, calibration.traceability});
  json.member("direction", wordOf(directionWords, calibration.direction));
  json.openList("models");
  for (const Model& model : calibration.models) {
    writeModel(json, model);
  }
  json.endList();
  writeUncertainty(json, calibration.uncertainty);
  writeCurve(json, calibration);
  writeRepeatability(json, calibration.passes);
  writeFindings(json, calibration);
  json.endObject();
  return json.take();
}

} // namespace straightedge::exporting
