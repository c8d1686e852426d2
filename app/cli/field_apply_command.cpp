#include "app/cli/field_apply_command.h"

#include "app/cli/apply_stream.h"
#include "app/cli/field_correction.h"
#include "core/export/field_calibration_json.h"

#include <memory>
#include <thread>

namespace straightedge::cli {

namespace {

struct FieldApplyOptions {
  std::string calibration, readings;
  std::string out = "-";
};

Result<int> apply(const FieldApplyOptions& options) {
  if (options.calibration == "-" && options.readings == "-") {
    return fail(ErrorKind::Usage, "calibration and readings cannot both come from standard input",
                "name one as a file");
  }
  const auto calibration = exporting::readFieldCalibration(options.calibration);
  if (!calibration) {
    return std::unexpected(calibration.error());
  }
  const auto applied = field::AppliedChain::prepare(calibration->chain);
  if (!applied) {
    Error error = applied.error();
    error.where = options.calibration;
    return std::unexpected(std::move(error));
  }
  const auto report = applyToReadings(options.readings, options.out, fieldCorrection(calibration->chain, *applied),
                                      std::thread::hardware_concurrency());
  if (!report) {
    return std::unexpected(report.error());
  }
  return 0;
}

} // namespace

void addFieldApplyCommand(CLI::App& parent, Work& work) {
  auto options = std::make_shared<FieldApplyOptions>();
  CLI::App* command = parent.add_subcommand("apply", "Correct a table of readings; adds the columns x_T, y_T and z_T");
  command->add_option("CALIBRATION.json", options->calibration, "Calibration, - for standard input")->required();
  command
      ->add_option("READINGS.csv", options->readings,
                   "Readings with the columns pt100_ohm, electronics_C, raw_x_T, raw_y_T and raw_z_T, - for standard "
                   "input")
      ->required();
  command->add_option("--out", options->out, "Result; without it, or as -, standard output")->type_name("FILE");
  command->callback([options, &work] { work = [options] { return apply(*options); }; });
}

} // namespace straightedge::cli
