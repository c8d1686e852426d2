// A program to be killed: goes on with the session's sweep and says after every commit how many samples are safe.
// kill_child SESSION stepwise|free-running real|virtual
#include "core/session/session.h"
#include "devices/capture/angle_capture.h"
#include "devices/simulated/simulated_angle_bench.h"
#include "tests/devices/kill_plan.h"

#include <cstdint>
#include <cstdio>
#include <string_view>
#include <unistd.h>

namespace {

using namespace straightedge;

/// Commits often, so that a kill often hits a commit; tells the number of the first sample that is not safe yet.
class ReportingSink : public session::SampleSink {
public:
  ReportingSink(session::SampleSink& real, std::int64_t next, std::size_t commitAfter)
      : m_real(real), m_next(next), m_commitAfter(commitAfter) {}

  Result<void> append(std::span<const session::AngleSample> samples) override {
    auto outcome = m_real.append(samples);
    m_next = samples.back().sequence + 1;
    m_uncommitted += samples.size();
    return outcome && m_uncommitted >= m_commitAfter ? commit() : outcome;
  }
  Result<void> recordGap(const session::SampleGap& gap) override { return m_real.recordGap(gap); }
  Result<void> commit() override {
    m_uncommitted = 0;
    auto outcome = m_real.commit();
    if (outcome && ::write(STDOUT_FILENO, &m_next, sizeof m_next) != sizeof m_next) {
      return fail(ErrorKind::Storage, "the pipe is closed", "");
    }
    return outcome;
  }

private:
  session::SampleSink& m_real;
  std::int64_t m_next;
  std::size_t m_commitAfter;
  std::size_t m_uncommitted = 0;
};

Result<void> run(const char* file, bool freeRunning, bool realTime) {
  auto session = session::Session::open(file);
  if (!session) {
    return std::unexpected(session.error());
  }
  const auto already = (*session)->angleSamples(session::SweepRole::Calibration);
  auto sink = (*session)->angleSink(session::SweepRole::Calibration);
  if (!already || !sink) {
    return std::unexpected(already ? sink.error() : already.error());
  }
  devices::SimulatedAngleSettings settings;
  settings.realTime = realTime;
  settings.stageSpeedDegPerS = freeRunning ? 90.0 : 3600.0;
  settings.seed = already->size();
  devices::SimulatedAngleBench bench(settings);
  ReportingSink reporting(**sink, already->empty() ? 0 : already->back().sequence + 1, realTime ? 5 : 100000);
  devices::AngleCapture capture(bench.bench(), reporting);
  if (auto started = capture.start(freeRunning ? tests::freeRunningKillPlan : tests::stepwiseKillPlan, *already);
      !started) {
    return started;
  }
  capture.waitUntilDone();
  const devices::CaptureProgress progress = capture.progress();
  if (progress.error) {
    return std::unexpected(*progress.error);
  }
  return {};
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    return 2;
  }
  const auto outcome = run(argv[1], std::string_view(argv[2]) == "free-running", std::string_view(argv[3]) == "real");
  if (!outcome) {
    std::fprintf(stderr, "%s\n", outcome.error().message().c_str());
    return 1;
  }
  return 0;
}
