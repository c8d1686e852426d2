#include "core/session/traceability_json.h"

#include <nlohmann/json.hpp>

namespace straightedge::session {

std::string traceabilityToJson(const Traceability& traceability) {
  const ReferenceInstrument& reference = traceability.reference;
  nlohmann::ordered_json json = {
      {"device", {{"serial", traceability.deviceSerial}, {"model", traceability.deviceModel}}},
      {"operator", traceability.operatorName},
      {"reference",
       {{"model", reference.model},
        {"serial", reference.serial},
        {"certificate", reference.certificate},
        {"due", reference.due},
        {"uncertainty", reference.uncertainty}}}};
  if (traceability.ambientC) {
    json["environment"]["ambient_C"] = *traceability.ambientC;
  }
  // Text that is not UTF-8 (typed elsewhere, pasted) must not keep the rest from being stored.
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

Result<Traceability> traceabilityFromJson(std::string_view text, const std::string& where) {
  try {
    const auto json = nlohmann::json::parse(text);
    const auto part = [&json](const char* name) { return json.value(name, nlohmann::json::object()); };
    const auto device = part("device");
    const auto reference = part("reference");
    const auto environment = part("environment");
    Traceability traceability;
    traceability.deviceSerial = device.value("serial", "");
    traceability.deviceModel = device.value("model", "");
    traceability.operatorName = json.value("operator", "");
    traceability.reference.model = reference.value("model", "");
    traceability.reference.serial = reference.value("serial", "");
    traceability.reference.certificate = reference.value("certificate", "");
    traceability.reference.due = reference.value("due", "");
    traceability.reference.uncertainty = reference.value("uncertainty", 0.0);
    if (environment.contains("ambient_C")) {
      traceability.ambientC = environment.at("ambient_C").get<double>();
    }
    return traceability;
  } catch (const nlohmann::json::exception& problem) {
    return fail(ErrorKind::Storage,
                std::string("what the session says about device and reference cannot be read (") + problem.what() + ")",
                "enter it anew", where);
  }
}

} // namespace straightedge::session
