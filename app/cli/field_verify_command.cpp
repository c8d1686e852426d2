#include "app/cli/field_verify_command.h"

#include "app/cli/campaign_input.h"
#include "app/cli/field_summary.h"
#include "app/cli/messages.h"
#include "app/cli/options.h"
#include "core/base/json_writer.h"
#include "core/base/number_text.h"
#include "core/export/field_calibration_json.h"
#include "core/field/block_names.h"
#include "core/field/names.h"
#include "core/field/verification.h"

#include <memory>

namespace straightedge::cli {

namespace {

struct FieldVerifyArguments {
  std::string calibration, campaign, limit;
  std::string of = "full-scale";
  bool json = false;
};

void writeRow(JsonWriter& json, const field::VerificationRow& row, field::PercentOf of) {
  const std::optional<field::ErrorFigures> figures =
      of == field::PercentOf::FullScale ? row.ofFullScale : row.ofReading;
  if (!figures) {
    return;
  }
  json.beginObject(true);
  json.member("axis", field::axisName(row.axis));
  json.member("state", field::stateName(row.state));
  json.member("mean_percent", figures->mean);
  json.member("sigma_percent", figures->sigma);
  json.member("peak_percent", figures->peak);
  json.member("points", row.points);
  json.endObject();
}

std::string asJson(const field::LimitReport& report, const field::FieldCalibration& calibration,
                   const field::Campaign& campaign) {
  JsonWriter json;
  json.beginObject();
  json.member("met", report.met);
  json.member("verdict", report.met ? "pass" : "fail");
  json.member("percent_of", report.of == field::PercentOf::FullScale ? "full-scale" : "reading");
  json.member("limit_percent", report.limitPercent);
  json.member("peak_percent", report.peakPercent);
  json.member("peak_before_percent", report.peakBeforePercent);
  json.member("worst_axis", field::axisName(report.worstAxis));
  json.member("full_scale_T", calibration.chain.fullScaleT);
  json.member("points", report.verification.points);
  json.openList("verification");
  for (const field::VerificationRow& row : report.verification.rows) {
    writeRow(json, row, report.of);
  }
  json.endList();
  json.openObject("source", true);
  json.member("file", campaign.name);
  json.member("sha256", campaign.sha256);
  json.member("points", campaign.rows.size());
  json.endObject();
  json.openObject("device", true);
  json.member("serial", calibration.traceability.deviceSerial);
  json.member("model", calibration.traceability.deviceModel);
  json.endObject();
  json.endObject();
  return json.take();
}

std::string asText(const field::LimitReport& report) {
  const auto percent = [](double value) { return formatForPeople(value, 4) + " %"; };
  const char* of = report.of == field::PercentOf::FullScale ? " of full scale" : " of reading";
  return std::string(report.met ? "PASS" : "FAIL") + ": largest error " + percent(report.peakPercent) + of +
         " on axis " + std::string(field::axisName(report.worstAxis)) + " over " +
         std::to_string(report.verification.points) + " points; limit " + percent(report.limitPercent) +
         "\nBefore correction: " + percent(report.peakBeforePercent) +
         "\nThe limit counts as met if no error exceeds it, of each axis by itself and after the axis matrix; "
         "uncertainty does not widen or narrow it.\n\n" +
         verificationTable(report.verification.rows, report.of);
}

Result<int> verifyCampaign(const FieldVerifyArguments& arguments) {
  constexpr double smallestLimit = 1e-9;
  constexpr double largestLimit = 100.0;
  const auto limit = optionNumber("--limit", arguments.limit, smallestLimit, largestLimit, "0.02");
  if (!limit) {
    return std::unexpected(limit.error());
  }
  if (arguments.calibration == "-" && arguments.campaign == "-") {
    return fail(ErrorKind::Usage, "calibration and campaign cannot both come from standard input",
                "name one as a file");
  }
  const auto calibration = exporting::readFieldCalibration(arguments.calibration);
  if (!calibration) {
    return std::unexpected(calibration.error());
  }
  const auto loaded = loadCampaign(arguments.campaign);
  if (!loaded) {
    return std::unexpected(loaded.error());
  }
  const auto of = arguments.of == "reading" ? field::PercentOf::Reading : field::PercentOf::FullScale;
  const auto report = field::verifyField(calibration->chain, loaded->campaign, *limit, of);
  if (!report) {
    return std::unexpected(withPath(report.error(), loaded->campaign.name, arguments.campaign));
  }
  print(arguments.json ? asJson(*report, *calibration, loaded->campaign) : asText(*report));
  return report->met ? 0 : 1;
}

} // namespace

void addFieldVerifyCommand(CLI::App& parent, Work& work) {
  auto arguments = std::make_shared<FieldVerifyArguments>();
  CLI::App* command = parent.add_subcommand(
      "verify", "Check the verification rows of a campaign against a limit: exit code 0 if met, 1 if not");
  command->add_option("CALIBRATION.json", arguments->calibration, "Calibration, - for standard input")->required();
  command->add_option("CAMPAIGN.csv", arguments->campaign, "Fresh campaign, - for standard input")->required();
  command->add_option("--limit", arguments->limit, "Largest error allowed after correction")
      ->type_name("PERCENT")
      ->required();
  command->add_option("--of", arguments->of, "What the limit is a percentage of")
      ->check(CLI::IsMember({"full-scale", "reading"}))
      ->type_name("full-scale|reading");
  command->add_flag("--json", arguments->json, "Print one JSON object");
  command->callback([arguments, &work] { work = [arguments] { return verifyCampaign(*arguments); }; });
}

} // namespace straightedge::cli
