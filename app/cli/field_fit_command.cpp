#include "app/cli/field_fit_command.h"

#include "app/cli/campaign_input.h"
#include "app/cli/field_summary.h"
#include "app/cli/messages.h"
#include "app/cli/options.h"
#include "app/cli/render_program.h"
#include "app/cli/sweep_input.h"
#include "core/base/file_output.h"
#include "core/base/time_stamp.h"
#include "core/export/field_calibration_json.h"
#include "core/export/field_tables.h"
#include "core/field/campaign_csv.h"
#include "core/field/field_fit.h"

#include <memory>

namespace straightedge::cli {

namespace {

struct FieldFitArguments {
  std::string campaign, out, order, fullScale, referenceTemperature;
  std::string method = "stepwise";
  TraceabilityOptions traceability;
  bool plots = false;
  bool report = false;
};

Result<field::FieldFitOptions> optionsFrom(const FieldFitArguments& arguments) {
  constexpr double leastFullScaleT = 1e-6;
  constexpr double mostFullScaleT = 100.0;
  constexpr double leastReferenceC = -273.15;
  constexpr double mostReferenceC = 500.0;
  field::FieldFitOptions options;
  options.method = arguments.method == "joint" ? field::FitMethod::Joint : field::FitMethod::Stepwise;
  if (!arguments.order.empty()) {
    const auto order = optionInteger("--order", arguments.order, field::lowestOrder, field::highestOrder, "5");
    if (!order) {
      return std::unexpected(order.error());
    }
    options.order = *order;
  }
  if (!arguments.fullScale.empty()) {
    const auto value = optionNumber("--full-scale", arguments.fullScale, leastFullScaleT, mostFullScaleT, "2");
    if (!value) {
      return std::unexpected(value.error());
    }
    options.fullScaleT = *value;
  }
  if (!arguments.referenceTemperature.empty()) {
    const auto value =
        optionNumber("--reference-temperature", arguments.referenceTemperature, leastReferenceC, mostReferenceC, "24");
    if (!value) {
      return std::unexpected(value.error());
    }
    options.referenceTemperatureC = *value;
  }
  return options;
}

std::vector<exporting::NamedTable> tablesOf(const field::FieldCalibration& calibration) {
  std::vector<exporting::NamedTable> tables{{"coefficients.csv", exporting::fieldCoefficientsCsv(calibration)}};
  if (!calibration.orders.empty()) {
    tables.push_back({"nonlinearity-orders.csv", exporting::ordersCsv(calibration)});
  }
  if (!calibration.verification.empty()) {
    tables.push_back({"verification.csv", exporting::fieldVerificationCsv(calibration)});
  }
  return tables;
}

/// calibration.json last: where it is, the tables are complete. Gives the names for the message.
Result<std::string> writeResults(const field::FieldCalibration& calibration, const std::string& out) {
  if (auto made = makeFolder(out); !made) {
    return std::unexpected(made.error());
  }
  std::string names = "calibration.json";
  for (const exporting::NamedTable& table : tablesOf(calibration)) {
    if (auto written = writeFileWhole(out + "/" + table.fileName, table.text); !written) {
      return std::unexpected(written.error());
    }
    names += ", " + table.fileName;
  }
  if (auto written = writeFileWhole(out + "/calibration.json", exporting::fieldCalibrationToJson(calibration));
      !written) {
    return std::unexpected(written.error());
  }
  return names;
}

Result<void> draw(const FieldFitArguments& arguments, const field::Campaign& campaign) {
  return renderRowsWithoutDisplay({.calibration = arguments.out + "/calibration.json",
                                   .out = arguments.out,
                                   .sweep = {},
                                   .plots = arguments.plots,
                                   .report = arguments.report},
                                  arguments.campaign, "campaign.csv", [&] { return field::campaignCsv(campaign); });
}

Result<int> fitField(const FieldFitArguments& arguments) {
  const auto options = optionsFrom(arguments);
  if (!options) {
    return std::unexpected(options.error());
  }
  const auto traceability = traceabilityFrom(arguments.traceability);
  if (!traceability) {
    return std::unexpected(traceability.error());
  }
  const auto loaded = loadCampaign(arguments.campaign);
  if (!loaded) {
    return std::unexpected(loaded.error());
  }
  auto run = field::calibrateField(loaded->campaign, *options, completed(*traceability, loaded->traceability));
  if (!run) {
    return std::unexpected(withPath(run.error(), loaded->campaign.name, arguments.campaign));
  }
  run->result.created = timeStampNow();
  if (auto uncertainty = field::uncertaintyOf(*run)) {
    run->result.uncertainty = *std::move(uncertainty);
  } else {
    printWarning("No uncertainty is stated: " + uncertainty.error().what + ".");
  }
  for (const field::FieldWarning& warning : run->result.warnings) {
    printWarning(warning.text);
  }
  const auto names = writeResults(run->result, arguments.out);
  if (!names) {
    return std::unexpected(names.error());
  }
  print(fieldSummaryOf(run->result));
  print("Written to " + arguments.out + ": " + *names + "\n");
  if (arguments.plots || arguments.report) {
    if (auto drawn = draw(arguments, loaded->campaign); !drawn) {
      return std::unexpected(drawn.error());
    }
  }
  return 0;
}

} // namespace

void addFieldFitCommand(CLI::App& parent, Work& work) {
  auto arguments = std::make_shared<FieldFitArguments>();
  CLI::App* command = parent.add_subcommand(
      "fit", "Fit every block of the correction to a campaign; writes calibration.json and tables");
  command->add_option("CAMPAIGN.csv", arguments->campaign, "Recorded campaign, - for standard input")->required();
  addOutputFolderOption(*command, arguments->out);
  command->add_option("--order", arguments->order, "Order of the nonlinearity's polynomial, 1 to 7; without it 5")
      ->type_name("N");
  command->add_option("--method", arguments->method, "Block after block, or all blocks together")
      ->check(CLI::IsMember({"stepwise", "joint"}))
      ->type_name("stepwise|joint");
  command->add_option("--full-scale", arguments->fullScale, "What percentages are of; without it 2")
      ->type_name("TESLA");
  command
      ->add_option("--reference-temperature", arguments->referenceTemperature,
                   "Temperature that the correction is for without drift; without it 24")
      ->type_name("C");
  command->add_flag("--plots", arguments->plots, "Also draw the plots (PNG, SVG, PDF)");
  command->add_flag("--report", arguments->report, "Also write the report");
  addTraceabilityOptions(*command, arguments->traceability, true, "TESLA");
  command->callback([arguments, &work] { work = [arguments] { return fitField(*arguments); }; });
}

} // namespace straightedge::cli
