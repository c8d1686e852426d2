#include "app/cli/apply_command.h"

#include "app/cli/angle_correction.h"
#include "app/cli/apply_stream.h"
#include "app/cli/options.h"
#include "core/export/calibration_json.h"

#include <memory>
#include <thread>

namespace straightedge::cli {

namespace {

struct ApplyOptions {
  std::string calibration, readings, model;
  std::string out = "-";
};

Result<int> apply(const ApplyOptions& options) {
  if (options.calibration == "-" && options.readings == "-") {
    return fail(ErrorKind::Usage, "calibration and readings cannot both come from standard input",
                "name one as a file");
  }
  const auto calibration = exporting::readCalibration(options.calibration);
  if (!calibration) {
    return std::unexpected(calibration.error());
  }
  const auto model = exporting::findModel(*calibration, options.model, options.calibration);
  if (!model) {
    return std::unexpected(model.error());
  }
  const auto report = applyToReadings(options.readings, options.out, angleCorrection(**model, calibration->direction),
                                      std::thread::hardware_concurrency());
  if (!report) {
    return std::unexpected(report.error());
  }
  return 0;
}

} // namespace

void addApplyCommand(CLI::App& parent, Work& work) {
  auto options = std::make_shared<ApplyOptions>();
  CLI::App* command = parent.add_subcommand("apply", "Correct a table of readings; adds the column corrected_deg");
  command->add_option("CALIBRATION.json", options->calibration, "Calibration, - for standard input")->required();
  command->add_option("READINGS.csv", options->readings, "Readings with a column sensor_deg, - for standard input")
      ->required();
  command->add_option("--model", options->model, "Model to apply; without it the first one in the file")
      ->type_name("MODEL");
  command->add_option("--out", options->out, "Result; without it, or as -, standard output")->type_name("FILE");
  command->callback([options, &work] { work = [options] { return apply(*options); }; });
}

} // namespace straightedge::cli
