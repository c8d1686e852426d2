#include "core/angle/quantisation.h"
#include "core/base/file_bytes.h"
#include "core/export/calibration_head.h"
#include "core/export/calibration_json.h"
#include "core/export/calibration_words.h"
#include "core/export/json_optional.h"
#include "core/export/json_reader.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace straightedge::exporting {

namespace {

using namespace angle;

/// A topic that a later version knows counts as Other: its text says what there is to say.
Warning::Topic topicOf(std::string_view text) {
  for (const auto& [topic, word] : topicWords) {
    if (word == text) {
      return topic;
    }
  }
  return Warning::Topic::Other;
}

void readModelErrors(JsonReader& reader, const JsonNode& node, ModelErrors& errors) {
  const JsonNode max = reader.object(node, "max_error_deg");
  const JsonNode rms = reader.object(node, "rms_error_deg");
  if (max && rms) {
    errors.maxCurveDeg = reader.number(max, "curve");
    errors.maxPointsDeg = reader.number(max, "points");
    errors.rmsCurveDeg = reader.number(rms, "curve");
    errors.rmsPointsDeg = reader.number(rms, "points");
  }
}

bool hasSize(JsonReader& reader, const JsonNode& list, std::size_t wanted) {
  if (list && list.size() != wanted) {
    reader.blame(list.path + " has " + std::to_string(list.size()) + " entries instead of " + std::to_string(wanted));
  }
  return list && list.size() == wanted;
}

HarmonicModel readHarmonics(JsonReader& reader, const JsonNode& node, int size) {
  constexpr int largestOrder = 2048; // beyond it the 4096-point curve knows nothing
  HarmonicModel model;
  model.offsetDeg = reader.number(node, "offset_deg");
  const JsonNode list = reader.list(node, "harmonics");
  if (!hasSize(reader, list, static_cast<std::size_t>(size))) {
    return model;
  }
  std::set<int> seen;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const JsonNode entry = list.item(i);
    if (!reader.requireObject(entry)) {
      return model;
    }
    const int order = static_cast<int>(reader.integer(entry, "order", 1, largestOrder));
    model.terms.push_back({order, reader.number(entry, "amplitude_deg"), reader.number(entry, "phase_rad")});
    if (!seen.insert(order).second) {
      reader.blame(entry.path + ".order is " + std::to_string(order) + " for the second time");
    }
  }
  return model;
}

Eigen::VectorXd readValues(JsonReader& reader, const JsonNode& node, int size) {
  Eigen::VectorXd values = Eigen::VectorXd::Zero(size);
  const JsonNode list = reader.list(node, "values_deg");
  if (hasSize(reader, list, static_cast<std::size_t>(size))) {
    for (std::size_t i = 0; i < list.size(); ++i) {
      values[static_cast<Eigen::Index>(i)] = reader.asNumber(list.item(i));
    }
  }
  return values;
}

StoredIntegers readStored(JsonReader& reader, const JsonNode& node, const ModelName& name) {
  StoredIntegers stored;
  stored.bits = static_cast<int>(reader.integer(node, "bits", 8, 16));
  stored.lsbDeg = reader.number(node, "lsb_deg");
  stored.biasDeg = reader.number(node, "bias_deg");
  stored.phaseLsbRad = optionalNumber(reader, node, "phase_lsb_rad");
  if (!reader.problem() && name.bits != stored.bits) {
    reader.blame(node.path + ".bits is " + std::to_string(stored.bits) + " but the model is " + name.text());
  }
  const JsonNode list = reader.list(node, "integers");
  const auto expected = static_cast<std::size_t>(name.kind == ModelKind::Harmonic ? 2 * name.size : name.size);
  if (!hasSize(reader, list, expected)) {
    return stored;
  }
  const long long half = 1LL << static_cast<unsigned>(stored.bits - 1);
  for (std::size_t i = 0; i < list.size(); ++i) {
    stored.integers.push_back(static_cast<int>(reader.asInteger(list.item(i), -half, half - 1)));
  }
  return stored;
}

/// Whether the integers give the values beside them, to within half a step.
bool standsFor(const StoredIntegers& stored, const ModelBody& body) {
  const double allowedDeg = 0.5 * std::abs(stored.lsbDeg) + 1e-9;
  const ModelBody rebuilt = bodyOf(stored, body);
  if (const auto* harmonics = std::get_if<HarmonicModel>(&body)) {
    const auto& terms = std::get<HarmonicModel>(rebuilt).terms;
    return std::ranges::equal(terms, harmonics->terms, [&](const HarmonicTerm& a, const HarmonicTerm& b) {
      return std::abs(a.amplitudeDeg - b.amplitudeDeg) <= allowedDeg;
    });
  }
  const auto difference = [&](const auto& a) {
    return (a.valuesDeg - std::get<std::decay_t<decltype(a)>>(rebuilt).valuesDeg).cwiseAbs().maxCoeff();
  };
  const auto* linear = std::get_if<LinearModel>(&body);
  return (linear != nullptr ? difference(*linear) : difference(std::get<LookupTableModel>(body))) <= allowedDeg;
}

Model readModel(JsonReader& reader, const JsonNode& node) {
  Model model;
  if (!reader.requireObject(node)) {
    return model;
  }
  const auto name = parseModelName(reader.text(node, "name"));
  if (!name) {
    reader.blame(node.path + ".name: " + name.error().what, name.error().remedy);
    return model;
  }
  model.name = *name;
  const long long entries = reader.integer(node, "storage_entries", 0, largestCount);
  if (!reader.problem() && entries != name->storageEntries()) {
    reader.blame(node.path + ".storage_entries is " + std::to_string(entries) + " but " + name->text() + " has " +
                 std::to_string(name->storageEntries()));
  }
  readModelErrors(reader, node, model.errors);
  switch (name->kind) {
  case ModelKind::Harmonic:
    model.body = readHarmonics(reader, node, name->size);
    break;
  case ModelKind::Linear:
    model.body = LinearModel{readValues(reader, node, name->size)};
    break;
  case ModelKind::LookupTable:
    model.body = LookupTableModel{readValues(reader, node, name->size)};
    break;
  }
  if (name->bits) {
    const JsonNode stored = reader.object(node, "stored");
    if (stored) {
      model.stored = readStored(reader, stored, *name);
      if (!reader.problem() && !standsFor(*model.stored, model.body)) {
        reader.blame(stored.path + " does not stand for the values of the model");
      }
    }
  }
  return model;
}

void readUncertainty(JsonReader& reader, const JsonNode& root, std::vector<UncertaintyBudget>& budgets) {
  const JsonNode list = root.optional("uncertainty");
  if (!list || !list.value->is_array()) {
    return; // the key is published without a form: other programs may put something else there
  }
  for (std::size_t i = 0; i < list.size(); ++i) {
    const JsonNode node = list.item(i);
    if (!reader.requireObject(node)) {
      return;
    }
    UncertaintyBudget budget;
    budget.model = reader.text(node, "model");
    budget.expandedDeg = reader.number(node, "expanded_deg");
    budget.coverageFactor = numberIfAny(reader, node, "coverage_factor", budget.coverageFactor);
    budget.combinedDeg = numberIfAny(reader, node, "combined_deg");
    const JsonNode contributions = listIfAny(reader, node, "contributions");
    for (std::size_t k = 0; k < contributions.size(); ++k) {
      const JsonNode entry = contributions.item(k);
      if (reader.requireObject(entry)) {
        budget.contributions.push_back(
            {reader.text(entry, "name"), reader.number(entry, "standard_deg"), textIfAny(reader, entry, "basis")});
      }
    }
    budgets.push_back(std::move(budget));
  }
}

void readHowMade(JsonReader& reader, const JsonNode& root, AngleCalibration& calibration) {
  if (const JsonNode curve = objectIfAny(reader, root, "curve")) {
    calibration.curveMethod = readWord(reader, curve, "method", curveWords);
    calibration.curveHarmonics =
        curve.optional("harmonics") ? static_cast<int>(reader.integer(curve, "harmonics", 0, 2048)) : 0;
    calibration.leaveOneOutRmsDeg = numberIfAny(reader, curve, "leave_one_out_rms_deg");
    calibration.leaveOneOutMaxDeg = numberIfAny(reader, curve, "leave_one_out_max_deg");
  }
  if (const JsonNode node = objectIfAny(reader, root, "repeatability")) {
    Repeatability& passes = calibration.passes;
    passes.turns = node.optional("turns") ? static_cast<int>(reader.integer(node, "turns", 0, 1'000'000)) : 1;
    passes.bothDirections = node.optional("both_directions") && reader.truth(node, "both_directions");
    passes.noiseDeg = optionalNumber(reader, node, "noise_deg");
    passes.repeatabilityDeg = optionalNumber(reader, node, "repeatability_deg");
    passes.hysteresisMaxDeg = optionalNumber(reader, node, "hysteresis_max_deg");
    passes.hysteresisRmsDeg = optionalNumber(reader, node, "hysteresis_rms_deg");
  }
  const JsonNode gaps = listIfAny(reader, root, "gaps");
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    if (const JsonNode gap = gaps.item(i); reader.requireObject(gap)) {
      calibration.gaps.push_back({reader.number(gap, "from_deg"), reader.number(gap, "width_deg")});
    }
  }
  const JsonNode warnings = listIfAny(reader, root, "warnings");
  for (std::size_t i = 0; i < warnings.size(); ++i) {
    if (const JsonNode warning = warnings.item(i); reader.requireObject(warning)) {
      calibration.warnings.push_back({topicOf(reader.text(warning, "topic")), reader.text(warning, "text")});
    }
  }
}

} // namespace

Result<AngleCalibration> calibrationFromJson(std::string_view text, const std::string& name) {
  const auto parsed = parseJson(text, name);
  if (!parsed) {
    return std::unexpected(parsed.error());
  }
  JsonReader reader(name);
  const JsonNode root{.value = &*parsed, .path = {}};
  AngleCalibration calibration;
  CalibrationHead head = readCalibrationHead(reader, root, "angle");
  if (const auto& problem = reader.problem()) {
    return std::unexpected(*problem);
  }
  calibration.created = std::move(head.created);
  calibration.software = std::move(head.software);
  calibration.source = std::move(head.source);
  calibration.traceability = std::move(head.traceability);
  calibration.direction = readWord(reader, root, "direction", directionWords);
  const JsonNode models = reader.list(root, "models");
  for (std::size_t i = 0; i < models.size() && !reader.problem(); ++i) {
    calibration.models.push_back(readModel(reader, models.item(i)));
  }
  if (models && models.size() == 0) {
    reader.blame("the calibration holds no models", "fit again with at least one --model");
  }
  readUncertainty(reader, root, calibration.uncertainty);
  readHowMade(reader, root, calibration);
  if (const auto& problem = reader.problem()) {
    return std::unexpected(*problem);
  }
  return calibration;
}

Result<AngleCalibration> readCalibration(const std::string& path) {
  const auto bytes = readFileBytes(path);
  if (!bytes) {
    return std::unexpected(bytes.error());
  }
  return calibrationFromJson(*bytes, inputName(path));
}

Result<const Model*> findModel(const AngleCalibration& calibration, std::string_view name, const std::string& file) {
  if (name.empty()) {
    return &calibration.models.front();
  }
  const auto wanted = parseModelName(name);
  if (!wanted) {
    return std::unexpected(wanted.error());
  }
  std::string present;
  for (const Model& model : calibration.models) {
    if (model.name == *wanted) {
      return &model;
    }
    present += (present.empty() ? "" : ", ") + model.name.text();
  }
  return fail(ErrorKind::Usage, "there is no model " + wanted->text() + " in the calibration",
              "choose one of " + present, file);
}

} // namespace straightedge::exporting
