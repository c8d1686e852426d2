// The field chain applied: vectors a second on one core, the plain loop against the one that works on several readings
// at a time; and megabytes of CSV a second through `field apply`, file to file in the page cache. The column CPU counts
// all threads, so that a busy machine can be told from slow code.
#include "app/cli/apply_stream.h"
#include "app/cli/field_correction.h"
#include "tests/core/base/temporary_folder.h"
#include "tests/core/field/sample_chain.h"

#include <benchmark/benchmark.h>

#include <array>
#include <charconv>

namespace straightedge {
namespace {

constexpr std::size_t inputBytes = std::size_t{100} << 20U;

struct Output {
  explicit Output(std::size_t count) : x(count), y(count), z(count) {}
  field::FieldColumns columns() { return {{x, y, z}}; }
  std::vector<double> x, y, z;
};

/// Argument: readings in the columns; 4,096 stay in the second cache, a million come from memory.
template <bool Plain>
void chain(benchmark::State& state) {
  const auto applied = field::AppliedChain::prepare(testing::sampleChain());
  const auto count = static_cast<std::size_t>(state.range(0));
  const testing::SampleReadings readings = testing::sampleReadings(count);
  Output output(count);
  for ([[maybe_unused]] auto _ : state) {
    if constexpr (Plain) {
      applied->correctPlainly(readings.columns(), output.columns());
    } else {
      applied->correct(readings.columns(), output.columns());
    }
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
  state.SetLabel(Plain ? "plain loop" : field::chainInstructions());
}

void addFixed(std::string& text, double value, int decimals) {
  std::array<char, 32> buffer{};
  text.append(
      buffer.data(),
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals).ptr);
}

struct Input {
  Input() {
    const testing::SampleReadings r = testing::sampleReadings(1 << 16U);
    std::string text = "pt100_ohm,electronics_C,raw_x_T,raw_y_T,raw_z_T\n";
    for (std::size_t row = 0; text.size() < inputBytes; ++row) {
      const std::size_t i = row % r.x.size();
      addFixed(text, r.pt100Ohm[i], 4);
      addFixed(text += ',', r.electronicsC[i], 4);
      addFixed(text += ',', r.x[i], 7);
      addFixed(text += ',', r.y[i], 7);
      addFixed(text += ',', r.z[i], 7);
      text += '\n';
    }
    size = text.size();
    folder.write("r.csv", text);
  }
  testing::TemporaryFolder folder;
  std::size_t size = 0;
};

/// Argument: threads beside the one that reads and writes.
void fieldApply(benchmark::State& state) {
  static const Input input;
  const field::CorrectionChain chain = testing::sampleChain();
  const auto applied = field::AppliedChain::prepare(chain);
  for ([[maybe_unused]] auto _ : state) {
    const auto report =
        cli::applyToReadings(input.folder.file("r.csv"), input.folder.file("out.csv"),
                             cli::fieldCorrection(chain, *applied), static_cast<unsigned>(state.range(0)));
    if (!report) {
      state.SkipWithError(report.error().message().c_str());
    }
  }
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(input.size));
}

BENCHMARK(chain<true>)->Name("chain_plain")->Arg(4096)->Arg(1 << 20);
BENCHMARK(chain<false>)->Name("chain_vectors")->Arg(4096)->Arg(1 << 20);
BENCHMARK(fieldApply)
    ->Arg(1)
    ->Arg(2)
    ->ArgName("threads")
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

} // namespace
} // namespace straightedge

BENCHMARK_MAIN();
