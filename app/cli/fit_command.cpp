#include "app/cli/fit_command.h"

#include "app/cli/messages.h"
#include "app/cli/options.h"
#include "app/cli/render_program.h"
#include "app/cli/summary_table.h"
#include "app/cli/sweep_input.h"
#include "core/angle/sweep_csv.h"
#include "core/base/file_output.h"
#include "core/base/time_stamp.h"
#include "core/export/calibration_json.h"
#include "core/export/tables.h"

#include <memory>

namespace straightedge::cli {

namespace {

struct FitOptions {
  std::string sweep, out;
  ModelOptions models;
  TraceabilityOptions traceability;
  bool plots = false;
  bool report = false;
};

/// calibration.json last: where it is, the tables are complete.
Result<void> writeResults(const angle::AngleCalibration& calibration, const std::string& out) {
  for (const angle::Model& model : calibration.models) {
    if (auto written =
            writeFileWhole(out + "/" + exporting::modelTableFileName(model), exporting::modelTableCsv(model));
        !written) {
      return written;
    }
  }
  return writeFileWhole(out + "/calibration.json", exporting::calibrationToJson(calibration));
}

Result<void> draw(const FitOptions& options, const angle::Sweep& sweep) {
  return renderRowsWithoutDisplay({.calibration = options.out + "/calibration.json",
                                   .out = options.out,
                                   .sweep = {},
                                   .plots = options.plots,
                                   .report = options.report},
                                  options.sweep, "sweep.csv", [&] { return angle::sweepToCsv(sweep); });
}

std::string listOfFiles(const angle::AngleCalibration& calibration) {
  std::string files = "calibration.json";
  for (const angle::Model& model : calibration.models) {
    files += ", " + exporting::modelTableFileName(model);
  }
  return files;
}

Result<int> fit(const FitOptions& options) {
  auto calibrationOptions = calibrationOptionsFrom(options.models);
  if (!calibrationOptions) {
    return std::unexpected(calibrationOptions.error());
  }
  const auto traceability = traceabilityFrom(options.traceability);
  if (!traceability) {
    return std::unexpected(traceability.error());
  }
  const auto loaded = loadSweep(options.sweep, session::SweepRole::Calibration);
  if (!loaded) {
    return std::unexpected(loaded.error());
  }
  const angle::Sweep* sweep = &loaded->sweep;
  auto run = angle::calibrate(*sweep, *calibrationOptions, completed(*traceability, loaded->traceability));
  if (!run) {
    return std::unexpected(withPath(run.error(), sweep->source.file, options.sweep));
  }
  run->result.created = timeStampNow();
  for (const angle::Warning& warning : run->result.warnings) {
    printWarning(warning.text);
  }
  if (auto made = makeFolder(options.out); !made) {
    return std::unexpected(made.error());
  }
  if (auto written = writeResults(run->result, options.out); !written) {
    return std::unexpected(written.error());
  }
  print(summaryOf(run->result));
  print("Written to " + options.out + ": " + listOfFiles(run->result) + "\n");
  if (options.plots || options.report) {
    if (auto drawn = draw(options, *sweep); !drawn) {
      return std::unexpected(drawn.error());
    }
  }
  return 0;
}

} // namespace

void addFitCommand(CLI::App& parent, Work& work) {
  auto options = std::make_shared<FitOptions>();
  CLI::App* command =
      parent.add_subcommand("fit", "Fit models to a sweep; writes calibration.json and a table per model");
  command->add_option("SWEEP.csv", options->sweep, "Recorded sweep, - for standard input")->required();
  addOutputFolderOption(*command, options->out);
  addModelOptions(*command, options->models);
  command->add_flag("--plots", options->plots, "Also draw the plots (PNG, SVG, PDF)");
  command->add_flag("--report", options->report, "Also write the report");
  addTraceabilityOptions(*command, options->traceability, true);
  command->callback([options, &work] { work = [options] { return fit(*options); }; });
}

} // namespace straightedge::cli
