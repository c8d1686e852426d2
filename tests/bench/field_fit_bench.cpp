// A teslameter campaign from file to calibration, step by step and jointly: 12,888 rows, and ten times as many.
#include "core/field/campaign_csv.h"
#include "core/field/field_fit.h"

#include <benchmark/benchmark.h>

#include <fstream>
#include <iterator>
#include <string>

namespace straightedge::field {
namespace {

/// The example campaign with every row written `times` times over: plateaus and sweeps get longer, not more.
std::string campaignText(int times) {
  std::ifstream file(STRAIGHTEDGE_TEST_DATA "/field/campaign.csv");
  std::string text;
  for (std::string line; std::getline(file, line);) {
    const int copies = text.empty() ? 1 : times; // one header
    for (int i = 0; i < copies; ++i) {
      text += line + "\n";
    }
  }
  return text;
}

void readAndFit(benchmark::State& state, FitMethod method) {
  const std::string text = campaignText(static_cast<int>(state.range(0)));
  FieldFitOptions options;
  options.method = method;
  double peak = 0.0;
  for ([[maybe_unused]] const auto iteration : state) {
    const auto campaign = parseCampaignCsv(text, "campaign.csv", "campaign.csv");
    if (!campaign) {
      state.SkipWithError(campaign.error().message().c_str());
      return;
    }
    const auto run = calibrateField(*campaign, options, {});
    if (!run) {
      state.SkipWithError(run.error().message().c_str());
      return;
    }
    peak = run->result.verification.back().ofFullScale.peak;
  }
  state.counters["peak_percent"] = peak;
}

void stepwise(benchmark::State& state) { readAndFit(state, FitMethod::Stepwise); }
void jointly(benchmark::State& state) { readAndFit(state, FitMethod::Joint); }

void readOnly(benchmark::State& state) {
  const std::string text = campaignText(static_cast<int>(state.range(0)));
  for ([[maybe_unused]] const auto iteration : state) {
    benchmark::DoNotOptimize(parseCampaignCsv(text, "campaign.csv", "campaign.csv"));
  }
}

BENCHMARK(readOnly)->Arg(1)->Arg(10)->Unit(benchmark::kMillisecond);
BENCHMARK(stepwise)->Arg(1)->Arg(10)->Unit(benchmark::kMillisecond);
BENCHMARK(jointly)->Arg(1)->Arg(10)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace straightedge::field

BENCHMARK_MAIN();
