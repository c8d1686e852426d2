// A field capture killed in full flight, again and again: every row it called committed is there.
#include "core/session/session.h"
#include "tests/core/session/session_fixture.h"
#include "tests/devices/field_fixture.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <random>
#include <thread>

namespace straightedge::devices {
namespace {

/// Commits often, and tells after each commit how many rows are safe.
class ReportingSink : public session::FieldSampleSink {
public:
  ReportingSink(session::FieldSampleSink& real, int reports) : m_real(real), m_reports(reports) {}
  Result<void> append(std::span<const session::FieldSample> samples) override {
    auto outcome = m_real.append(samples);
    m_next = samples.back().sequence + 1;
    return outcome && m_next % 5 == 0 ? commit() : outcome;
  }
  Result<void> recordGap(const session::SampleGap& gap) override { return m_real.recordGap(gap); }
  Result<void> commit() override {
    auto outcome = m_real.commit();
    if (outcome && m_next > 0) {
      std::ignore = ::write(m_reports, &m_next, sizeof m_next);
    }
    return outcome;
  }

private:
  session::FieldSampleSink& m_real;
  int m_reports;
  std::int64_t m_next = 0;
};

FieldPlan longPlan() {
  FieldPlanShape shape;
  shape.steps = {field::CampaignStep::Offset};
  shape.sweepRows = 100000;
  shape.rowS = 0.001;
  shape.temperatureSettleS = 0.0;
  return makeFieldPlan(shape);
}

void captureUntilKilled(const std::filesystem::path& file, int reports) {
  auto session = session::Session::open(file);
  if (!session) {
    return;
  }
  const auto already = *(*session)->fieldSamples(session::SweepRole::Calibration);
  SimulatedFieldSettings settings;
  settings.seed = already.size();
  settings.placingS = 0.0;
  SimulatedFieldBench bench(settings);
  auto sink = *(*session)->fieldSink(session::SweepRole::Calibration);
  ReportingSink reporting(*sink, reports);
  FieldCapture capture(bench.bench(), reporting);
  if (capture.start(longPlan(), already)) {
    capture.waitUntilDone();
  }
}

TEST(FieldKillTest, NoCommittedRowIsLostInTenKills) {
  const tests::TemporaryFolder folder;
  const std::filesystem::path file = folder / "killed.sedge";
  ASSERT_TRUE(session::Session::create(file, session::SessionKind::Field));
  std::mt19937 random(4);
  std::int64_t safe = 0;
  for (int kill = 0; kill < 10; ++kill) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      ::close(ends[0]);
      captureUntilKilled(file, ends[1]);
      ::_exit(1);
    }
    ::close(ends[1]);
    ASSERT_EQ(::read(ends[0], &safe, sizeof safe), static_cast<ssize_t>(sizeof safe)) << "it captures";
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 100000));
    ::kill(child, SIGKILL);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status)) << "ended by itself";
    while (::read(ends[0], &safe, sizeof safe) == static_cast<ssize_t>(sizeof safe)) {
    }
    ::close(ends[0]);
    const auto session = session::Session::open(file);
    ASSERT_TRUE(session) << session.error().message();
    const auto samples = *(*session)->fieldSamples(session::SweepRole::Calibration);
    ASSERT_GE(static_cast<std::int64_t>(samples.size()), safe) << "kill " << kill;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      ASSERT_EQ(samples[i].sequence, static_cast<std::int64_t>(i));
    }
  }
  EXPECT_GT(safe, 20) << "there was something to lose";
}

} // namespace
} // namespace straightedge::devices
