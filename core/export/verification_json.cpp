#include "core/export/verification_json.h"

#include "core/base/json_writer.h"

namespace straightedge::exporting {

namespace {
const char* verdictWord(angle::Verdict verdict) {
  switch (verdict) {
  case angle::Verdict::Pass:
    return "pass";
  case angle::Verdict::Fail:
    return "fail";
  case angle::Verdict::PassWithinUncertainty:
    return "pass-within-uncertainty";
  case angle::Verdict::FailWithinUncertainty:
    return "fail-within-uncertainty";
  }
  return "fail";
}
} // namespace

std::string verificationToJson(const angle::VerificationReport& report, const Traceability& traceability,
                               const SourceRecord& source) {
  JsonWriter json;
  json.beginObject();
  json.member("met", report.met);
  json.member("verdict", verdictWord(report.verdict));
  json.member("model", report.model);
  json.member("limit_deg", report.limitDeg);
  json.member("max_error_deg", report.maxErrorDeg);
  json.member("rms_error_deg", report.rmsErrorDeg);
  json.member("max_error_before_deg", report.maxErrorBeforeDeg);
  json.member("rms_error_before_deg", report.rmsErrorBeforeDeg);
  json.member("points", report.points);
  json.key("expanded_uncertainty_deg");
  if (report.expandedUncertaintyDeg > 0.0) {
    json.value(report.expandedUncertaintyDeg);
  } else {
    json.null();
  }
  json.member("decision_rule", report.decisionRule);
  json.openObject("source", true);
  json.member("file", source.file);
  json.member("sha256", source.sha256);
  json.member("points", source.points);
  json.endObject();
  json.openObject("device", true);
  json.member("serial", traceability.deviceSerial);
  json.member("model", traceability.deviceModel);
  json.endObject();
  json.endObject();
  return json.take();
}

} // namespace straightedge::exporting
