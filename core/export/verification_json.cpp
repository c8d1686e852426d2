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
  JsonWriter writer;
  writer.beginObject();
  writer.member("met", report.met);
  writer.member("verdict", verdictWord(report.verdict));
  writer.member("model", report.model);
  writer.member("limit_deg", report.limitDeg);
  writer.member("max_error_deg", report.maxErrorDeg);
  writer.member("rms_error_deg", report.rmsErrorDeg);
  writer.member("max_error_before_deg", report.maxErrorBeforeDeg);
  writer.member("rms_error_before_deg", report.rmsErrorBeforeDeg);
  writer.member("points", report.points);
  writer.key("expanded_uncertainty_deg");
  if (report.expandedUncertaintyDeg > 0.0) {
    writer.value(report.expandedUncertaintyDeg);
  } else {
    writer.null();
  }
  writer.member("decision_rule", report.decisionRule);
  writer.openObject("source", true);
  writer.member("file", source.file);
  writer.member("sha256", source.sha256);
  writer.member("points", source.points);
  writer.endObject();
  writer.openObject("device", true);
  writer.member("serial", traceability.deviceSerial);
  writer.member("model", traceability.deviceModel);
  writer.endObject();
  writer.endObject();
  return writer.take();
}

} // namespace straightedge::exporting
