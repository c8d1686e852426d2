#include "app/cli/verify_command.h"

#include "app/cli/messages.h"
#include "app/cli/options.h"
#include "app/cli/sweep_input.h"
#include "core/angle/sweep_csv.h"
#include "core/angle/verification.h"
#include "core/base/number_text.h"
#include "core/export/calibration_json.h"
#include "core/export/verification_json.h"

#include <memory>

namespace straightedge::cli {

namespace {

struct VerifyOptions {
  std::string calibration, sweep, model, limit;
  bool json = false;
};

std::string inDegrees(double value) { return formatForPeople(value, 4) + "°"; }

std::string asText(const angle::VerificationReport& report) {
  return std::string(report.met ? "PASS" : "FAIL") + ": " + report.model + " over " + std::to_string(report.points) +
         " points: " + inDegrees(report.maxErrorDeg) + " maximum error, " + inDegrees(report.rmsErrorDeg) +
         " rms; limit " + inDegrees(report.limitDeg) + "\nBefore correction: " + inDegrees(report.maxErrorBeforeDeg) +
         " maximum, " + inDegrees(report.rmsErrorBeforeDeg) + " rms\n" + report.decisionRule + "\n";
}

Result<int> verifySweep(const VerifyOptions& options) {
  constexpr double smallestLimit = 1e-9;
  constexpr double largestLimit = 180.0;
  const auto limit = optionNumber("--limit", options.limit, smallestLimit, largestLimit, "0.5");
  if (!limit) {
    return std::unexpected(limit.error());
  }
  if (options.calibration == "-" && options.sweep == "-") {
    return fail(ErrorKind::Usage, "calibration and sweep cannot both come from standard input", "name one as a file");
  }
  const auto calibration = exporting::readCalibration(options.calibration);
  if (!calibration) {
    return std::unexpected(calibration.error());
  }
  const auto model = exporting::findModel(*calibration, options.model, options.calibration);
  if (!model) {
    return std::unexpected(model.error());
  }
  const auto loaded = loadSweep(options.sweep, session::SweepRole::Verification);
  if (!loaded) {
    return std::unexpected(loaded.error());
  }
  const angle::Sweep* sweep = &loaded->sweep;
  const auto report = angle::verify(*calibration, **model, *sweep, *limit);
  if (!report) {
    return std::unexpected(withPath(report.error(), sweep->source.file, options.sweep));
  }
  print(options.json ? exporting::verificationToJson(*report, calibration->traceability, sweep->source)
                     : asText(*report));
  return report->met ? 0 : 1;
}

} // namespace

void addVerifyCommand(CLI::App& parent, Work& work) {
  auto options = std::make_shared<VerifyOptions>();
  CLI::App* command =
      parent.add_subcommand("verify", "Check a fresh sweep against a limit: exit code 0 if met, 1 if not");
  command->add_option("CALIBRATION.json", options->calibration, "Calibration, - for standard input")->required();
  command->add_option("SWEEP.csv", options->sweep, "Fresh sweep, - for standard input")->required();
  command->add_option("--model", options->model, "Model to verify; without it the first one in the file")
      ->type_name("MODEL");
  command->add_option("--limit", options->limit, "Largest error allowed after correction")
      ->type_name("DEG")
      ->required();
  command->add_flag("--json", options->json, "Print one JSON object");
  command->callback([options, &work] { work = [options] { return verifySweep(*options); }; });
}

} // namespace straightedge::cli
