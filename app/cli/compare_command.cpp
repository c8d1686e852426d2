#include "app/cli/compare_command.h"

#include "app/cli/messages.h"
#include "app/cli/options.h"
#include "app/cli/render_program.h"
#include "app/cli/scratch_folder.h"
#include "app/cli/sweep_input.h"
#include "core/angle/calibration.h"
#include "core/angle/comparison.h"
#include "core/angle/model_limits.h"
#include "core/angle/sweep_csv.h"
#include "core/base/file_output.h"
#include "core/base/time_stamp.h"
#include "core/export/calibration_json.h"
#include "core/export/tables.h"

#include <algorithm>
#include <memory>
#include <optional>

namespace straightedge::cli {

namespace {

struct CompareOptions {
  std::string sweep, out, targetError, budget, bits;
  std::string curve = "auto";
  bool plots = false;
};

struct Demands {
  std::optional<double> targetErrorDeg;
  std::optional<int> budgetEntries;
  std::optional<int> bits;
};

Result<Demands> demandsFrom(const CompareOptions& options) {
  Demands demands;
  constexpr double largestError = 180.0;
  constexpr int largestBudget = 1'000'000;
  if (!options.targetError.empty()) {
    const auto value = optionNumber("--target-error", options.targetError, 1e-9, largestError, "0.5");
    if (!value) {
      return std::unexpected(value.error());
    }
    demands.targetErrorDeg = *value;
  }
  if (!options.budget.empty()) {
    const auto value = optionInteger("--budget", options.budget, 1, largestBudget, "64");
    if (!value) {
      return std::unexpected(value.error());
    }
    demands.budgetEntries = *value;
  }
  if (!options.bits.empty()) {
    const auto value = optionInteger("--bits", options.bits, angle::smallestBits, angle::largestBits, "12");
    if (!value) {
      return std::unexpected(value.error());
    }
    demands.bits = *value;
  }
  return demands;
}

/// A demand that was not stated is the one the window starts with.
std::vector<angle::Recommendation> recommendationsFor(const angle::Comparison& comparison, const Demands& demands) {
  constexpr double usualTarget = 0.5;
  constexpr int usualBudget = 64;
  const bool none = !demands.targetErrorDeg && !demands.budgetEntries;
  std::vector<angle::Recommendation> list;
  if (demands.targetErrorDeg || none) {
    list.push_back(angle::recommendForTarget(comparison, demands.targetErrorDeg.value_or(usualTarget)));
  }
  if (demands.budgetEntries || none) {
    list.push_back(angle::recommendForBudget(comparison, demands.budgetEntries.value_or(usualBudget)));
  }
  return list;
}

/// The drawing program starts from a calibration: the usual models and the recommended ones, for the plots alone.
Result<void> draw(const CompareOptions& options, const angle::Sweep& sweep,
                  angle::CalibrationOptions calibrationOptions,
                  const std::vector<angle::Recommendation>& recommendations) {
  for (const angle::Recommendation& recommendation : recommendations) {
    auto& models = calibrationOptions.models;
    if (recommendation.choice && std::find(models.begin(), models.end(), recommendation.choice->name) == models.end()) {
      models.push_back(recommendation.choice->name);
    }
  }
  auto run = angle::calibrate(sweep, calibrationOptions, {});
  if (!run) {
    return std::unexpected(run.error());
  }
  run->result.created = timeStampNow();
  const auto scratch = ScratchFolder::create();
  if (!scratch) {
    return std::unexpected(scratch.error());
  }
  const RenderRequest request{scratch->file("calibration.json"), options.out, scratch->file("sweep.csv"), true, false};
  if (auto written = writeFileWhole(request.calibration, exporting::calibrationToJson(run->result)); !written) {
    return written;
  }
  if (auto written = writeFileWhole(*request.sweep, angle::sweepToCsv(sweep)); !written) {
    return written;
  }
  return renderWithoutDisplay(request);
}

Result<int> compare(const CompareOptions& options) {
  const auto demands = demandsFrom(options);
  if (!demands) {
    return std::unexpected(demands.error());
  }
  const auto calibrationOptions = calibrationOptionsFrom({{}, options.curve});
  const auto loaded = loadSweep(options.sweep, session::SweepRole::Calibration);
  if (!loaded) {
    return std::unexpected(loaded.error());
  }
  const angle::Sweep* sweep = &loaded->sweep;
  const auto aligned = angle::alignSweep(*sweep);
  if (!aligned) {
    return std::unexpected(withPath(aligned.error(), sweep->source.file, options.sweep));
  }
  const auto curve = angle::fitCurve(*aligned, calibrationOptions->curve);
  if (!curve) {
    Error error = curve.error();
    error.where = error.where.empty() ? sweep->source.file : error.where;
    return std::unexpected(withPath(std::move(error), sweep->source.file, options.sweep));
  }
  for (const angle::Warning& warning : aligned->warnings) {
    printWarning(warning.text);
  }
  const auto comparison = angle::compareFully(*curve, {demands->bits}, {});
  if (!comparison) {
    return std::unexpected(comparison.error());
  }
  if (auto made = makeFolder(options.out); !made) {
    return std::unexpected(made.error());
  }
  if (auto written = writeFileWhole(options.out + "/comparison.csv", exporting::comparisonCsv(*comparison)); !written) {
    return std::unexpected(written.error());
  }
  const auto recommendations = recommendationsFor(*comparison, *demands);
  for (const angle::Recommendation& recommendation : recommendations) {
    print(recommendation.sentence + "\n");
  }
  print("Written to " + options.out + ": comparison.csv (" + std::to_string(comparison->rows.size()) + " sizes)\n");
  if (options.plots) {
    if (auto drawn = draw(options, *sweep, *calibrationOptions, recommendations); !drawn) {
      return std::unexpected(drawn.error());
    }
  }
  return 0;
}

} // namespace

void addCompareCommand(CLI::App& parent, Work& work) {
  auto options = std::make_shared<CompareOptions>();
  CLI::App* command =
      parent.add_subcommand("compare", "Compare every way of storing the correction; writes comparison.csv");
  command->add_option("SWEEP.csv", options->sweep, "Recorded sweep, - for standard input")->required();
  addOutputFolderOption(*command, options->out);
  command->add_option("--target-error", options->targetError, "Recommend the least storage that keeps within it")
      ->type_name("DEG");
  command->add_option("--budget", options->budget, "Recommend the least error within it")->type_name("ENTRIES");
  command->add_option("--bits", options->bits, "Every model stored as integers of so many bits (8 to 16)")
      ->type_name("N");
  command->add_option("--curve", options->curve, "How the correction curve is drawn through the points")
      ->check(CLI::IsMember({"auto", "interpolate", "regress"}))
      ->type_name("auto|interpolate|regress");
  command->add_flag("--plots", options->plots, "Also draw the plots (PNG, SVG, PDF)");
  command->callback([options, &work] { work = [options] { return compare(*options); }; });
}

} // namespace straightedge::cli
