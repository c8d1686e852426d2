// A teslameter campaign from file (in the page cache) to calibration, step by step and jointly: 12,888 rows, and ten
// times as many; and how many times as long ten times the rows take.
#include "core/field/campaign_csv.h"
#include "core/field/field_fit.h"
#include "tests/core/base/temporary_folder.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <fstream>
#include <limits>
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

std::string campaignFile(int times) {
  static const testing::TemporaryFolder folder;
  const std::string name = std::to_string(times) + ".csv";
  return std::ifstream(folder.file(name)) ? folder.file(name) : folder.write(name, campaignText(times));
}

enum class Work : std::uint8_t { ReadOnly, Stepwise, Joint };

/// False, and said to the benchmark, where the campaign is refused.
bool readAndFit(benchmark::State& state, const std::string& file, Work work) {
  const auto campaign = readCampaignCsv(file);
  if (!campaign) {
    state.SkipWithError(campaign.error().message().c_str());
    return false;
  }
  if (work == Work::ReadOnly) {
    return true;
  }
  FieldFitOptions options;
  options.method = work == Work::Joint ? FitMethod::Joint : FitMethod::Stepwise;
  const auto run = calibrateField(*campaign, options, {});
  if (!run) {
    state.SkipWithError(run.error().message().c_str());
    return false;
  }
  state.counters["peak_percent"] = run->result.verification.back().ofFullScale.peak;
  return true;
}

/// Argument: how many times the rows of the example.
void campaign(benchmark::State& state, Work work) {
  const std::string file = campaignFile(static_cast<int>(state.range(0)));
  for ([[maybe_unused]] const auto iteration : state) {
    if (!readAndFit(state, file, work)) {
      return;
    }
  }
}

double processorSeconds() {
  timespec time{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Both campaigns in turn, so that a busy machine is busy for both. The counter `times` is the shortest time of the
/// long one, in processor time, over the shortest of the example.
void tenTimesTheRows(benchmark::State& state, Work work) {
  constexpr std::array<int, 2> sizes = {1, 10};
  std::array<double, 2> shortest;
  shortest.fill(std::numeric_limits<double>::infinity());
  const std::array<std::string, 2> files = {campaignFile(sizes[0]), campaignFile(sizes[1])};
  for ([[maybe_unused]] const auto iteration : state) {
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      const double begin = processorSeconds();
      if (!readAndFit(state, files[i], work)) {
        return;
      }
      shortest[i] = std::min(shortest[i], processorSeconds() - begin);
    }
  }
  state.counters["times"] = shortest[1] / shortest[0];
}

BENCHMARK_CAPTURE(campaign, read_only, Work::ReadOnly)->Arg(1)->Arg(10)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(campaign, stepwise, Work::Stepwise)->Arg(1)->Arg(10)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(campaign, jointly, Work::Joint)->Arg(1)->Arg(10)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(tenTimesTheRows, read_only, Work::ReadOnly)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(tenTimesTheRows, stepwise, Work::Stepwise)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(tenTimesTheRows, jointly, Work::Joint)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace straightedge::field

BENCHMARK_MAIN();
