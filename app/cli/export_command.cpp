#include "app/cli/export_command.h"

#include "app/cli/messages.h"
#include "app/cli/options.h"
#include "app/cli/session_export.h"
#include "core/angle/session_sweep.h"
#include "core/base/file_bytes.h"
#include "core/base/file_output.h"
#include "core/export/calibration_json.h"
#include "core/export/field_calibration_json.h"
#include "core/export/field_tables.h"
#include "core/export/tables.h"

#include <memory>

namespace straightedge::cli {

namespace {

struct ExportOptions {
  std::string calibration, model, format, out;
};

/// A table per model in a folder.
Result<void> writeTables(const angle::AngleCalibration& calibration, const std::string& folder) {
  if (auto made = makeFolder(folder); !made) {
    return made;
  }
  for (const angle::Model& model : calibration.models) {
    if (auto written =
            writeFileWhole(folder + "/" + exporting::modelTableFileName(model), exporting::modelTableCsv(model));
        !written) {
      return written;
    }
  }
  return {};
}

/// One table where one file is meant, a folder with a table per block otherwise.
Result<int> exportField(const field::FieldCalibration& calibration, const ExportOptions& options) {
  if (!options.model.empty()) {
    return fail(ErrorKind::Usage, "a field calibration has no models", "leave out --model", options.calibration);
  }
  Result<void> written;
  if (options.format == "json") {
    written = writeFileWhole(options.out, exporting::fieldCalibrationToJson(calibration));
  } else if (options.out == "-" || options.out.ends_with(".csv")) {
    written = writeFileWhole(options.out, exporting::fieldCoefficientsCsv(calibration));
  } else {
    written = makeFolder(options.out);
    for (const exporting::NamedTable& table : exporting::fieldBlockTables(calibration)) {
      if (written) {
        written = writeFileWhole(options.out + "/" + table.fileName, table.text);
      }
    }
  }
  if (!written) {
    return std::unexpected(written.error());
  }
  return 0;
}

Result<int> exportAngle(angle::AngleCalibration angleCalibration, const ExportOptions& options) {
  auto* const calibration = &angleCalibration;
  if (!options.model.empty()) {
    const auto model = exporting::findModel(*calibration, options.model, options.calibration);
    if (!model) {
      return std::unexpected(model.error());
    }
    calibration->models = {angle::Model(**model)};
    std::erase_if(calibration->uncertainty, [&](const angle::UncertaintyBudget& budget) {
      return budget.model != calibration->models.front().name.text();
    });
  }
  Result<void> written;
  if (options.format == "json") {
    written = writeFileWhole(options.out, exporting::calibrationToJson(*calibration));
  } else if (calibration->models.size() == 1) {
    written = writeFileWhole(options.out, exporting::modelTableCsv(calibration->models.front()));
  } else if (options.out == "-") {
    return fail(ErrorKind::Usage, "--out - cannot take " + std::to_string(calibration->models.size()) + " tables",
                "choose one with --model, or name a folder");
  } else {
    written = writeTables(*calibration, options.out);
  }
  if (!written) {
    return std::unexpected(written.error());
  }
  return 0;
}

Result<int> exportCalibration(const ExportOptions& options) {
  if (angle::isSessionFile(options.calibration)) {
    if (auto written = exportSession(options.calibration, options.format, options.out); !written) {
      return std::unexpected(std::move(written.error()));
    }
    return 0;
  }
  const auto bytes = readFileBytes(options.calibration);
  if (!bytes) {
    return std::unexpected(bytes.error());
  }
  const std::string name = inputName(options.calibration);
  if (exporting::isFieldCalibration(*bytes)) {
    const auto calibration = exporting::fieldCalibrationFromJson(*bytes, name);
    return calibration ? exportField(*calibration, options) : std::unexpected(calibration.error());
  }
  auto calibration = exporting::calibrationFromJson(*bytes, name);
  return calibration ? exportAngle(*std::move(calibration), options) : std::unexpected(calibration.error());
}

} // namespace

void addExportCommand(CLI::App& parent, Work& work) {
  auto options = std::make_shared<ExportOptions>();
  CLI::App* command = parent.add_subcommand("export", "Write the tables of a calibration in another format");
  command
      ->add_option("CALIBRATION.json", options->calibration,
                   "Calibration, - for standard input; or a session (.sedge), whose raw samples are written as CSV")
      ->required();
  command->add_option("--model", options->model, "Model to write; without it all")->type_name("MODEL");
  command->add_option("--format", options->format, "Format")
      ->check(CLI::IsMember({"csv", "json"}))
      ->type_name("csv|json")
      ->required();
  command
      ->add_option("--out", options->out,
                   "File, - for standard output; a folder for the CSV tables of several models or blocks")
      ->type_name("PATH")
      ->required();
  command->callback([options, &work] { work = [options] { return exportCalibration(*options); }; });
}

} // namespace straightedge::cli
