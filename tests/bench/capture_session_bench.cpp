// Samples stored a second, what capture costs beside the bench, and how quickly a large session opens.
#include "core/session/session.h"
#include "devices/capture/angle_capture.h"
#include "devices/capture/live_queue.h"
#include "devices/simulated/simulated_angle_bench.h"
#include "tests/core/session/temporary_folder.h"

#include <benchmark/benchmark.h>

#include <vector>

namespace straightedge {
namespace {

std::vector<session::AngleSample> samplesFrom(std::int64_t first, int count) {
  std::vector<session::AngleSample> samples(static_cast<std::size_t>(count));
  for (session::AngleSample& sample : samples) {
    sample.sequence = first++;
    sample.encoderDeg = 0.036 * static_cast<double>(sample.sequence);
    sample.sensorDeg = 123.456;
  }
  return samples;
}

/// Commits of 2,500 samples: a quarter of a second at 10,000 a second.
void storeSamples(benchmark::State& state) {
  const tests::TemporaryFolder folder;
  auto session = *session::Session::create(folder / "a.sedge", session::SessionKind::Angle);
  auto sink = *session->angleSink(session::SweepRole::Calibration);
  std::int64_t next = 0;
  for (auto _ : state) {
    const auto batch = samplesFrom(next, 2500);
    next += 2500;
    if (!sink->append(batch) || !sink->commit()) {
      state.SkipWithError("not stored");
      break;
    }
  }
  state.SetItemsProcessed(next);
}
BENCHMARK(storeSamples)->UseRealTime()->Unit(benchmark::kMillisecond);

/// One turn at 10,000 samples a second on the virtual clock, into a session: bench, thread, queue, commits.
void captureOneTurn(benchmark::State& state) {
  const tests::TemporaryFolder folder;
  devices::SimulatedAngleSettings settings;
  settings.realTime = false;
  devices::SimulatedAngleBench bench(settings);
  std::int64_t samples = 0;
  int run = 0;
  for (auto _ : state) {
    auto session = *session::Session::create(folder / std::to_string(run++), session::SessionKind::Angle);
    auto sink = *session->angleSink(session::SweepRole::Calibration);
    devices::AngleCapture capture(bench.bench(), *sink);
    if (!capture.start({.pointsPerTurn = 64, .sampleRateHz = 10000.0})) {
      state.SkipWithError("not started");
      break;
    }
    capture.waitUntilDone();
    samples += static_cast<std::int64_t>(capture.takeNewSamples().size());
  }
  state.SetItemsProcessed(samples);
}
BENCHMARK(captureOneTurn)->UseRealTime()->Unit(benchmark::kMillisecond);

/// Blocks as they come at 10,000 samples a second looked at every 10 ms, emptied once per frame.
void passTheLiveQueue(benchmark::State& state) {
  devices::LiveQueue queue;
  const auto block = samplesFrom(0, 100);
  std::int64_t samples = 0;
  for (auto _ : state) {
    queue.push(block);
    queue.push(block);
    samples += static_cast<std::int64_t>(queue.takeAll().size());
  }
  state.SetItemsProcessed(samples);
}
BENCHMARK(passTheLiveQueue);

void openLargeSession(benchmark::State& state) {
  const tests::TemporaryFolder folder;
  {
    auto session = *session::Session::create(folder / "a.sedge", session::SessionKind::Angle);
    auto sink = *session->angleSink(session::SweepRole::Calibration);
    if (!sink->append(samplesFrom(0, 100000)) || !sink->commit()) {
      state.SkipWithError("not stored");
    }
  }
  const bool read = state.range(0) != 0;
  for (auto _ : state) {
    auto session = *session::Session::open(folder / "a.sedge");
    if (read) {
      benchmark::DoNotOptimize(session->angleSamples(session::SweepRole::Calibration));
    }
  }
}
BENCHMARK(openLargeSession)->ArgName("and_read")->Arg(0)->Arg(1)->UseRealTime()->Unit(benchmark::kMillisecond);

} // namespace
} // namespace straightedge

BENCHMARK_MAIN();
