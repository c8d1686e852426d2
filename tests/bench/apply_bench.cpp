// How fast `angle apply` is: megabytes of CSV a second, rows of about 20 bytes, file to file in the page cache. As a
// ratio: against copying the same bytes through the same blocks without looking at them. The column CPU counts all
// threads, so that a busy machine can be told from slow code.
#include "app/cli/angle_correction.h"
#include "app/cli/apply_stream.h"
#include "core/base/file_output.h"
#include "core/base/input_file.h"
#include "core/base/line_blocks.h"
#include "tests/bench/readings.h"
#include "tests/core/base/temporary_folder.h"

#include <benchmark/benchmark.h>

namespace straightedge {
namespace {

constexpr std::size_t inputBytes = std::size_t{100} << 20U;

struct Input {
  Input() : size(bench::readingsText(inputBytes).size()) { folder.write("r.csv", bench::readingsText(inputBytes)); }
  testing::TemporaryFolder folder;
  std::size_t size;
};

const Input& input() {
  static const Input instance;
  return instance;
}

void countBytes(benchmark::State& state) {
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(input().size));
}

void copyBlocks(benchmark::State& state) {
  input();
  for ([[maybe_unused]] auto _ : state) {
    LineBlocks blocks(std::move(*InputFile::open(input().folder.file("r.csv"))));
    auto out = PendingFile::create(input().folder.file("copy.csv"));
    for (std::string block; blocks.next(block).value_or(false);) {
      if (!out->write(block)) {
        state.SkipWithError("cannot write");
      }
    }
    benchmark::DoNotOptimize(out->commit(Durability::Cached));
  }
  countBytes(state);
}

/// Arguments: model (0 harmonic:4, 1 linear:32, 2 lut:64), threads.
void apply(benchmark::State& state) {
  const auto calibration = bench::sampleCalibration();
  const auto& model = calibration.models[static_cast<std::size_t>(state.range(0))];
  state.SetLabel(model.name.text());
  input();
  for ([[maybe_unused]] auto _ : state) {
    const auto report =
        cli::applyToReadings(input().folder.file("r.csv"), input().folder.file("out.csv"),
                             cli::angleCorrection(model, calibration.direction), static_cast<unsigned>(state.range(1)));
    if (!report) {
      state.SkipWithError(report.error().message().c_str());
    }
  }
  countBytes(state);
}

BENCHMARK(copyBlocks)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(apply)
    ->ArgsProduct({{0, 1, 2}, {1, 2}})
    ->ArgNames({"model", "threads"})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

} // namespace
} // namespace straightedge

BENCHMARK_MAIN();
