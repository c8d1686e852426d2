// How many 32-point files a second `angle batch` fits, with a warm cache, and how much of the time is the mathematics
// alone (ratio of the two rates with one job). The column CPU counts all threads.
#include "app/cli/batch_run.h"
#include "core/angle/sweep_csv.h"
#include "core/base/file_output.h"
#include "core/base/time_stamp.h"
#include "tests/bench/readings.h"
#include "tests/core/base/temporary_folder.h"

#include <benchmark/benchmark.h>

namespace straightedge {
namespace {

constexpr int files = 2000;

struct Inputs {
  Inputs() {
    for (int i = 0; i < files; ++i) {
      const std::string name = "s" + std::to_string(i);
      list.push_back({folder.write(name + ".csv", bench::sweepText(i)), name + ".json"});
    }
  }
  testing::TemporaryFolder folder;
  std::vector<cli::BatchInput> list;
};

const Inputs& inputs() {
  static const Inputs instance;
  return instance;
}

void mathematicsAlone(benchmark::State& state) {
  const auto sweep = angle::parseSweepCsv(bench::sweepText(0), "sweep", "sweep");
  for ([[maybe_unused]] auto _ : state) {
    auto run = angle::calibrate(*sweep, {}, {});
    benchmark::DoNotOptimize(run);
  }
  state.SetItemsProcessed(state.iterations());
}

/// A fresh folder each time, as a user's first run; items are files.
void batch(benchmark::State& state) {
  for ([[maybe_unused]] auto _ : state) {
    state.PauseTiming();
    auto out = std::make_unique<testing::TemporaryFolder>();
    cli::BatchOptions options;
    options.created = timeStampNow();
    options.out = out->path();
    options.jobs = static_cast<unsigned>(state.range(0));
    inputs();
    state.ResumeTiming();
    const auto outcomes = cli::runBatch(inputs().list, options, [](std::size_t, std::size_t) {});
    state.PauseTiming();
    for (const auto& outcome : outcomes) {
      if (outcome.problem) {
        state.SkipWithError(outcome.problem->message().c_str());
      }
    }
    out.reset();
    state.ResumeTiming();
  }
  state.SetItemsProcessed(state.iterations() * files);
}

BENCHMARK(mathematicsAlone)->Unit(benchmark::kMicrosecond);
BENCHMARK(batch)
    ->Arg(1)
    ->Arg(2)
    ->ArgName("jobs")
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

} // namespace
} // namespace straightedge

BENCHMARK_MAIN();
