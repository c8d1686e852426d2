#include "app/cli/batch_command.h"

#include "app/cli/batch_run.h"
#include "app/cli/messages.h"
#include "app/cli/options.h"
#include "core/base/file_output.h"
#include "core/base/time_stamp.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <thread>
#include <unistd.h>

namespace straightedge::cli {

namespace {

struct Options {
  std::string source, out, jobs;
  ModelOptions models;
  TraceabilityOptions traceability;
};

/// One line that is written over again and again; only where somebody watches.
class ProgressLine {
public:
  explicit ProgressLine(std::size_t total) : m_total(total), m_shown(::isatty(STDERR_FILENO) == 1) {}
  void show(std::size_t done, std::size_t rejected) const {
    if (m_shown) {
      std::fprintf(stderr, "\r%zu of %zu sweeps, %zu rejected", done, m_total, rejected);
    }
  }
  void end() const {
    if (m_shown) {
      std::fputs("\r\033[K", stderr);
    }
  }

private:
  std::size_t m_total;
  bool m_shown;
};

Result<unsigned> jobsFrom(const std::string& text) {
  constexpr int most = 1024;
  if (text.empty()) {
    return std::max(1U, std::thread::hardware_concurrency());
  }
  const auto jobs = optionInteger("--jobs", text, 1, most, "4");
  if (!jobs) {
    return std::unexpected(jobs.error());
  }
  return static_cast<unsigned>(*jobs);
}

/// The rejected ones on standard error; the summary file; the exit code.
Result<int> conclude(const std::vector<BatchOutcome>& outcomes, const BatchInputs& inputs,
                     const BatchOptions& options) {
  std::string summary = summaryHeader();
  std::size_t rejected = 0;
  std::size_t warned = 0;
  for (const BatchOutcome& outcome : outcomes) {
    if (outcome.problem && outcome.problem->kind == ErrorKind::Storage) {
      return std::unexpected(*outcome.problem);
    }
    if (outcome.problem) {
      ++rejected;
      printError(*outcome.problem);
    }
    warned += outcome.warnings > 0 ? 1U : 0U;
    summary += outcome.summaryRows;
  }
  for (const std::string& renamed : inputs.renamed) {
    printWarning(renamed);
  }
  if (warned > 0) {
    printWarning(std::to_string(warned) + " of " + std::to_string(outcomes.size()) +
                 " sweeps have warnings; see their JSON files and the column warnings of summary.csv");
  }
  if (auto written = writeFileWhole(options.out + "/summary.csv", summary); !written) {
    return std::unexpected(written.error());
  }
  print(std::to_string(outcomes.size() - rejected) + " of " + std::to_string(outcomes.size()) + " sweeps calibrated, " +
        std::to_string(rejected) + " rejected. Written to " + options.out + ": NAME.json each, summary.csv\n");
  return rejected == 0 ? 0 : exitCode(ErrorKind::Input);
}

Result<int> batch(const Options& options) {
  BatchOptions batchOptions;
  batchOptions.out = options.out;
  const auto jobs = jobsFrom(options.jobs);
  if (!jobs) {
    return std::unexpected(jobs.error());
  }
  batchOptions.jobs = *jobs;
  auto calibration = calibrationOptionsFrom(options.models);
  if (!calibration) {
    return std::unexpected(calibration.error());
  }
  batchOptions.calibration = std::move(*calibration);
  auto traceability = traceabilityFrom(options.traceability);
  if (!traceability) {
    return std::unexpected(traceability.error());
  }
  batchOptions.traceability = std::move(*traceability);
  batchOptions.created = timeStampNow();
  const auto inputs = findBatchInputs(options.source, options.out);
  if (!inputs) {
    return std::unexpected(inputs.error());
  }
  if (auto made = makeFolder(options.out); !made) {
    return std::unexpected(made.error());
  }
  const ProgressLine line(inputs->list.size());
  const auto outcomes =
      runBatch(inputs->list, batchOptions, [&](std::size_t done, std::size_t rejected) { line.show(done, rejected); });
  line.end();
  return conclude(outcomes, *inputs, batchOptions);
}

} // namespace

void addBatchCommand(CLI::App& parent, Work& work) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      parent.add_subcommand("batch", "Fit many sweeps on all cores; writes NAME.json each and summary.csv");
  command
      ->add_option(
          "DIR|LIST", options->source,
          "Folder whose *.csv and *.sedge are fitted, or a file with a path in each line, - for standard input")
      ->required();
  addOutputFolderOption(*command, options->out);
  addModelOptions(*command, options->models);
  command->add_option("--jobs", options->jobs, "Sweeps at the same time; without it as many as there are cores")
      ->type_name("N");
  addTraceabilityOptions(*command, options->traceability, false);
  command->callback([options, &work] { work = [options] { return batch(*options); }; });
}

} // namespace straightedge::cli
