#include "app/gui/figures/render_command.h"

#include "app/gui/figures/export_files.h"
#include "app/gui/figures/field_render.h"
#include "core/angle/sweep_csv.h"
#include "core/base/file_bytes.h"
#include "core/export/calibration_json.h"
#include "core/export/field_calibration_json.h"
#include "core/export/tables.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

namespace straightedge::gui {

namespace {

struct RenderOptions {
  QString calibration;
  QString out;
  QString sweep; ///< or campaign
  QString comparison;
  bool plots = false;
  bool report = false;
};

const char* const usage = "usage: straightedge --render CALIBRATION.json --out DIR [--plots] [--report] "
                          "[--sweep SWEEP.csv] [--campaign CAMPAIGN.csv] [--comparison FILE]";

Result<RenderOptions> parse(const QStringList& arguments) {
  RenderOptions options;
  for (qsizetype i = 0; i < arguments.size(); ++i) {
    const QString& argument = arguments[i];
    QString* value = argument == QLatin1String("--out")          ? &options.out
                     : argument == QLatin1String("--sweep")      ? &options.sweep
                     : argument == QLatin1String("--campaign")   ? &options.sweep
                     : argument == QLatin1String("--comparison") ? &options.comparison
                                                                 : nullptr;
    if (value != nullptr) {
      if (i + 1 >= arguments.size()) {
        return fail(ErrorKind::Usage, argument.toStdString() + " needs a value", usage);
      }
      *value = arguments[++i];
    } else if (argument == QLatin1String("--plots")) {
      options.plots = true;
    } else if (argument == QLatin1String("--report")) {
      options.report = true;
    } else if (argument.startsWith(QLatin1Char('-')) && argument != QLatin1String("-")) {
      return fail(ErrorKind::Usage, "unknown option " + argument.toStdString(), usage);
    } else if (options.calibration.isEmpty()) {
      options.calibration = argument;
    } else {
      return fail(ErrorKind::Usage, "one calibration at a time, not also " + argument.toStdString(), usage);
    }
  }
  if (options.calibration.isEmpty() || options.out.isEmpty()) {
    return fail(ErrorKind::Usage, options.out.isEmpty() ? "--out is missing" : "the calibration is missing", usage);
  }
  if (!options.plots && !options.report) {
    options.plots = options.report = true;
  }
  return options;
}

/// A sweep belongs to a calibration when it gives the same models again.
bool givesSameModels(const angle::AngleCalibration& recomputed, const angle::AngleCalibration& stated) {
  constexpr double toleranceDeg = 1e-6;
  const auto close = [](double a, double b) { return std::abs(a - b) <= toleranceDeg; };
  return recomputed.direction == stated.direction &&
         std::ranges::equal(recomputed.models, stated.models, [&close](const angle::Model& a, const angle::Model& b) {
           return a.name == b.name && close(a.errors.maxCurveDeg, b.errors.maxCurveDeg) &&
                  close(a.errors.rmsPointsDeg, b.errors.rmsPointsDeg) &&
                  close(a.correctionDeg(0.0), b.correctionDeg(0.0));
         });
}

Result<void> addSweep(AngleResults& results, const QString& file) {
  Result<angle::Sweep> sweep = angle::readSweepCsv(file.toStdString());
  if (!sweep) {
    return std::unexpected(sweep.error());
  }
  angle::CalibrationOptions options;
  options.curve.method = results.calibration.curveMethod;
  options.models.clear();
  for (const angle::Model& model : results.calibration.models) {
    options.models.push_back(model.name);
  }
  Result<angle::CalibrationRun> run = angle::calibrate(*sweep, options, results.calibration.traceability);
  if (!run) {
    return std::unexpected(run.error());
  }
  if (!givesSameModels(run->result, results.calibration)) {
    return fail(ErrorKind::Input, "the sweep is not the one that the calibration was made from",
                "give the sweep that calibration.json names under source, or leave out --sweep", file.toStdString());
  }
  results.calibration.passes = run->result.passes; // per-angle lists are not part of the file
  results.comparison =
      std::make_shared<const angle::Comparison>(angle::compareFully(run->curve, {}, {}).value_or(angle::Comparison{}));
  results.sweep = std::make_shared<const angle::Sweep>(std::move(*sweep));
  results.run = std::make_shared<const angle::CalibrationRun>(std::move(*run));
  return {};
}

ExportChoices picturesOnly(const RenderOptions& options) {
  return {.calibration = false,
          .tablesCsv = false,
          .tablesJson = false,
          .sweep = false,
          .comparison = false,
          .plotsPng = options.plots,
          .plotsSvg = options.plots,
          .plotsPdf = options.plots,
          .reportPdf = options.report,
          .reportHtml = options.report};
}

Result<void> write(const std::vector<FileToWrite>& files, const RenderOptions& options) {
  const Result<QStringList> written = writeFiles(files, options.out, {});
  if (written && static_cast<std::size_t>(written->size()) < files.size()) {
    const std::size_t missing = files.size() - static_cast<std::size_t>(written->size());
    std::fprintf(stderr,
                 "straightedge: %zu three-dimensional picture%s not drawn: OpenGL 3.2 (EGL) and the module "
                 "lib/straightedge/straightedge_gl.so are needed\n",
                 missing, missing == 1 ? " is" : "s are");
  }
  return written ? Result<void>{} : Result<void>(std::unexpected(written.error()));
}

Result<void> renderAngle(const RenderOptions& options, std::string_view text) {
  Result<angle::AngleCalibration> calibration =
      exporting::calibrationFromJson(text, inputName(options.calibration.toStdString()));
  if (!calibration) {
    return std::unexpected(calibration.error());
  }
  const auto results = std::make_shared<AngleResults>();
  results->calibration = std::move(*calibration);
  if (!options.sweep.isEmpty()) {
    if (const Result<void> added = addSweep(*results, options.sweep); !added) {
      return added;
    }
  }
  if (!options.comparison.isEmpty()) {
    const std::string name = options.comparison.toStdString();
    Result<std::string> bytes = readFileBytes(name);
    if (!bytes) {
      return std::unexpected(bytes.error());
    }
    Result<angle::Comparison> comparison = exporting::comparisonFromCsv(std::move(*bytes), name);
    if (!comparison) {
      return std::unexpected(comparison.error());
    }
    results->comparison = std::make_shared<const angle::Comparison>(std::move(*comparison));
  }
  return write(filesToWrite(results, picturesOnly(options)), options);
}

Result<void> renderField(const RenderOptions& options, std::string_view text) {
  if (!options.comparison.isEmpty()) {
    return fail(ErrorKind::Usage, "a field calibration takes no --comparison", usage);
  }
  Result<field::FieldCalibration> calibration =
      exporting::fieldCalibrationFromJson(text, inputName(options.calibration.toStdString()));
  if (!calibration) {
    return std::unexpected(calibration.error());
  }
  const auto results = fieldResultsOf(*std::move(calibration), options.sweep.toStdString());
  if (!results) {
    return std::unexpected(results.error());
  }
  return write(filesToWrite(*results, picturesOnly(options)), options);
}

Result<void> render(const QStringList& arguments) {
  const Result<RenderOptions> options = parse(arguments);
  if (!options) {
    return std::unexpected(options.error());
  }
  const Result<std::string> text = readFileBytes(options->calibration.toStdString());
  if (!text) {
    return std::unexpected(text.error());
  }
  return exporting::isFieldCalibration(*text) ? renderField(*options, *text) : renderAngle(*options, *text);
}

} // namespace

int renderCalibration(const QStringList& arguments) {
  const Result<void> done = render(arguments);
  if (done) {
    return 0;
  }
  std::fprintf(stderr, "straightedge: %s\n", done.error().message().c_str());
  return exitCode(done.error().kind);
}

} // namespace straightedge::gui
