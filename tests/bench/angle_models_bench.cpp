// Fits and comparison from a given curve, and the whole chain from 32 recorded points to the default three models.
#include "core/angle/calibration.h"
#include "core/angle/comparison.h"
#include "core/angle/minimax_linear.h"
#include "core/angle/sweep_csv.h"

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <iostream>
#include <string>

namespace straightedge::angle {
namespace {

template <typename T>
T valueOrExit(Result<T> result) {
  if (!result) {
    std::cerr << result.error().message() << '\n';
    std::exit(1);
  }
  return std::move(*result);
}

const CorrectionCurve& curve() {
  static const CorrectionCurve fitted = valueOrExit(
      fitCurve(valueOrExit(alignSweep(valueOrExit(readSweepCsv(STRAIGHTEDGE_TEST_DATA "/angle/side_shaft_32.csv"))))));
  return fitted;
}

void fit(benchmark::State& state, const std::string& text) {
  const ModelName name = valueOrExit(parseModelName(text));
  for (auto _ : state) {
    benchmark::DoNotOptimize(fitModel(curve(), name));
  }
}
BENCHMARK_CAPTURE(fit, harmonic4, "harmonic:4");
BENCHMARK_CAPTURE(fit, linear32, "linear:32");
BENCHMARK_CAPTURE(fit, lut64, "lut:64");
BENCHMARK_CAPTURE(fit, linear32Minimax, "linear:32@minimax");
BENCHMARK_CAPTURE(fit, linear1024, "linear:1024");

/// Goal: at most 40 µs.
void fitDefaultModels(benchmark::State& state) {
  for (auto _ : state) {
    for (const ModelName& name : defaultModels()) {
      benchmark::DoNotOptimize(fitModel(curve(), name));
    }
  }
}
BENCHMARK(fitDefaultModels);

/// Recorded points -> curve -> default three models with their errors; tests/bench/numpy_ratio compares it.
void calibrateFromPoints(benchmark::State& state) {
  const Sweep sweep = valueOrExit(readSweepCsv(STRAIGHTEDGE_TEST_DATA "/angle/side_shaft_32.csv"));
  const CalibrationOptions options{defaultModels(), {}};
  for (auto _ : state) {
    benchmark::DoNotOptimize(calibrate(sweep, options, {}));
  }
}
BENCHMARK(calibrateFromPoints);

/// Goal: at most 50 ms on one core, so that the plot follows a drag.
void compareEverySize(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(compareQuick(curve()));
  }
}
BENCHMARK(compareEverySize)->Unit(benchmark::kMillisecond);

/// In the background: seconds at most.
void compareInTheBackground(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(compareFully(curve(), {}, {}));
  }
}
BENCHMARK(compareInTheBackground)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace straightedge::angle

BENCHMARK_MAIN();
