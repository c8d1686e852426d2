#include "core/export/calibration_head.h"

#include "core/export/calibration_json.h"
#include "core/export/json_optional.h"

namespace straightedge::exporting {

namespace {

void writeReference(JsonWriter& json, const ReferenceInstrument& reference) {
  if (reference.model.empty() && reference.serial.empty() && reference.certificate.empty() && reference.due.empty() &&
      reference.uncertainty == 0.0) {
    return;
  }
  json.openObject("reference");
  json.member("model", reference.model);
  json.member("serial", reference.serial);
  json.member("certificate", reference.certificate);
  json.member("due", reference.due);
  json.member("uncertainty", reference.uncertainty);
  json.endObject();
}

/// Format, version and kind: what this program cannot read at all.
void checkKind(JsonReader& reader, const JsonNode& root, std::string_view wanted) {
  const std::string otherFile = "name a calibration.json that Straightedge wrote";
  const JsonNode format = root.optional("format");
  if (!format || !format.value->is_string() || *format.value != "straightedge-calibration") {
    reader.blame("this is not a Straightedge calibration", otherFile);
    return;
  }
  const long long version = reader.integer(root, "version", 0, largestCount);
  if (!reader.problem() && version != calibrationFormatVersion) {
    reader.blame("the file is of version " + std::to_string(version) + ", this program reads version " +
                     std::to_string(calibrationFormatVersion),
                 version > calibrationFormatVersion ? "use a later Straightedge" : otherFile);
    return;
  }
  const std::string kind = reader.text(root, "kind");
  if (reader.problem() || kind == wanted) {
    return;
  }
  if (kind == "field" || kind == "angle") {
    const auto article = [](std::string_view word) { return (word == "angle" ? "an " : "a ") + std::string(word); };
    reader.blame("this is " + article(kind) + " calibration, " + article(wanted) + " calibration is needed",
                 "use the " + kind + " commands or name another file");
  } else {
    reader.blame("the calibration is of the unknown kind \"" + kind + "\"", "use a later Straightedge");
  }
}

Traceability readTraceability(JsonReader& reader, const JsonNode& root) {
  Traceability traceability;
  if (const JsonNode device = objectIfAny(reader, root, "device")) {
    traceability.deviceSerial = textIfAny(reader, device, "serial");
    traceability.deviceModel = textIfAny(reader, device, "model");
  }
  traceability.operatorName = textIfAny(reader, root, "operator");
  if (const JsonNode reference = objectIfAny(reader, root, "reference")) {
    traceability.reference.model = textIfAny(reader, reference, "model");
    traceability.reference.serial = textIfAny(reader, reference, "serial");
    traceability.reference.certificate = textIfAny(reader, reference, "certificate");
    traceability.reference.due = textIfAny(reader, reference, "due");
    traceability.reference.uncertainty = numberIfAny(reader, reference, "uncertainty");
  }
  if (const JsonNode environment = objectIfAny(reader, root, "environment")) {
    traceability.ambientC = optionalNumber(reader, environment, "ambient_C");
  }
  return traceability;
}

} // namespace

void writeCalibrationHead(JsonWriter& json, std::string_view kind, const CalibrationHead& head) {
  json.member("format", "straightedge-calibration");
  json.member("version", calibrationFormatVersion);
  json.member("kind", kind);
  json.member("created", head.created);
  json.member("software", head.software);
  json.openObject("source", true);
  json.member("file", head.source.file);
  json.member("sha256", head.source.sha256);
  json.member("points", head.source.points);
  json.endObject();
  json.openObject("device", true);
  json.member("serial", head.traceability.deviceSerial);
  json.member("model", head.traceability.deviceModel);
  json.endObject();
  if (!head.traceability.operatorName.empty()) {
    json.member("operator", head.traceability.operatorName);
  }
  writeReference(json, head.traceability.reference);
  if (head.traceability.ambientC) {
    json.openObject("environment", true);
    json.member("ambient_C", *head.traceability.ambientC);
    json.endObject();
  }
}

CalibrationHead readCalibrationHead(JsonReader& reader, const JsonNode& root, std::string_view kind) {
  CalibrationHead head;
  if (reader.requireObject(root)) {
    checkKind(reader, root, kind);
  }
  if (reader.problem()) {
    return head;
  }
  head.created = textIfAny(reader, root, "created");
  head.software = textIfAny(reader, root, "software");
  if (const JsonNode source = objectIfAny(reader, root, "source")) {
    head.source.file = textIfAny(reader, source, "file");
    head.source.sha256 = textIfAny(reader, source, "sha256");
    head.source.points = source.optional("points") ? reader.integer(source, "points", 0, largestCount) : 0;
  }
  head.traceability = readTraceability(reader, root);
  return head;
}

} // namespace straightedge::exporting
