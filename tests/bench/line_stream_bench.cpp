// What lines of a board cost: cut and read, one angle or both in a line. At 10,000 lines a second a microsecond a line
// is 1 % of a core.
#include "devices/instruments/line_reader.h"

#include <benchmark/benchmark.h>

#include <string>

namespace straightedge::devices {
namespace {

std::string linesOf(int count, bool both) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    const double angle = 0.036 * i;
    text += std::to_string(angle) + (both ? "," + std::to_string(angle + 20.0) : "") + "\r\n";
  }
  return text;
}

/// Pieces of 1024 bytes, as transfers bring them.
void BM_LinesOfABoard(benchmark::State& state) {
  const bool both = state.range(0) != 0;
  LineFormat format;
  format.columns.resize(both ? 2 : 1);
  format.columns.front().quantity = "angle";
  format.columns.back().index = both ? 2 : 1;
  const std::string text = linesOf(10000, both);
  LineReader reader(format);
  std::int64_t lines = 0;
  for (auto _ : state) {
    for (std::size_t at = 0; at < text.size(); at += 1024) {
      std::vector<std::vector<double>> readings;
      reader.take(std::string_view(text).substr(at, 1024), readings);
      lines += static_cast<std::int64_t>(readings.size());
    }
  }
  state.SetItemsProcessed(lines);
}
BENCHMARK(BM_LinesOfABoard)->ArgName("both")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace straightedge::devices

BENCHMARK_MAIN();
