// A capture killed at random moments, again and again: every sample it called committed is there, in a file that opens.
#include "core/angle/session_sweep.h"
#include "tests/core/session/session_fixture.h"
#include "tests/devices/kill_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <map>
#include <poll.h>
#include <random>
#include <spawn.h>
#include <thread>

namespace straightedge {
namespace {

class KillTest : public testing::TestWithParam<const char*> {
protected:
  struct Child {
    pid_t id = 0;
    int reports = -1;
  };
  Child start(const char* clock) const {
    int ends[2];
    EXPECT_EQ(::pipe(ends), 0);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_addclose(&actions, ends[0]);
    posix_spawn_file_actions_addclose(&actions, ends[1]);
    std::string words[] = {STRAIGHTEDGE_BINARY_DIR "/kill_child", m_file.string(), GetParam(), clock};
    char* arguments[] = {words[0].data(), words[1].data(), words[2].data(), words[3].data(), nullptr};
    Child child;
    EXPECT_EQ(::posix_spawn(&child.id, arguments[0], &actions, nullptr, arguments, environ), 0);
    posix_spawn_file_actions_destroy(&actions);
    ::close(ends[1]);
    child.reports = ends[0];
    return child;
  }
  /// The last number that the child reported; `before` where it reported none. Ends with the child's end of the pipe.
  static std::int64_t lastReport(const Child& child, std::int64_t before) {
    std::int64_t report = 0;
    while (::read(child.reports, &report, sizeof report) == static_cast<ssize_t>(sizeof report)) {
      before = report;
    }
    ::close(child.reports);
    return before;
  }
  static int endOf(const Child& child) {
    int status = 0;
    EXPECT_EQ(::waitpid(child.id, &status, 0), child.id);
    return status;
  }

  tests::TemporaryFolder m_folder;
  std::filesystem::path m_file = m_folder / "killed.sedge";
};

TEST_P(KillTest, NoCommittedSampleIsLostInFiftyKills) {
  constexpr int kills = 50;
  const devices::AnglePlan plan =
      std::string(GetParam()) == "stepwise" ? tests::stepwiseKillPlan : tests::freeRunningKillPlan;
  ASSERT_TRUE(session::Session::create(m_file, session::SessionKind::Angle));
  // A free-running child first turns to where it left off, as long as all before it lived.
  const unsigned longestLife = plan.sampleRateHz > 0.0 ? 40000 : 150000;
  std::mt19937 random(20);
  std::int64_t safe = 0;
  for (int kill = 0; kill < kills; ++kill) {
    const Child child = start("real");
    // Two of three are killed once they capture, the others also while they start and open the file.
    if (kill % 3 != 0) {
      pollfd reported{.fd = child.reports, .events = POLLIN, .revents = 0};
      ASSERT_EQ(::poll(&reported, 1, 60000), 1) << "the child never reported";
    }
    std::this_thread::sleep_for(std::chrono::microseconds(random() % (kill % 3 != 0 ? longestLife : 30000)));
    ::kill(child.id, SIGKILL);
    const int status = endOf(child);
    ASSERT_TRUE(WIFSIGNALED(status)) << "ended by itself: the plan is too short";
    safe = lastReport(child, safe);

    const auto session = session::Session::open(m_file);
    ASSERT_TRUE(session) << "kill " << kill << ": " << session.error().message();
    const auto samples = (*session)->angleSamples(session::SweepRole::Calibration);
    ASSERT_TRUE(samples) << samples.error().message();
    ASSERT_GE(static_cast<std::int64_t>(samples->size()), safe) << "kill " << kill;
    for (std::size_t i = 0; i < samples->size(); ++i) {
      ASSERT_EQ((*samples)[i].sequence, static_cast<std::int64_t>(i)) << "kill " << kill;
    }
    if (kill % 2 == 0) {
      ASSERT_TRUE((*session)->close());
    }
  }
  EXPECT_GT(safe, 10 * kills) << "there was something to lose";

  const Child last = start("virtual");
  safe = lastReport(last, safe);
  ASSERT_EQ(endOf(last), 0);
  const auto session = session::Session::openReadOnly(m_file);
  ASSERT_TRUE(session);
  const auto samples = *(*session)->angleSamples(session::SweepRole::Calibration);
  EXPECT_EQ(static_cast<std::int64_t>(samples.size()), safe);
  std::map<int, int> readings;
  std::map<int, int> attempts;
  for (const auto& sample : samples) {
    ++readings[sample.point];
    attempts[sample.point] = std::max(attempts[sample.point], sample.attempt);
  }
  EXPECT_EQ(readings.size(), devices::plannedPoints(plan).size()) << "the sweep is complete";
  if (plan.sampleRateHz == 0.0) {
    EXPECT_TRUE(std::all_of(readings.begin(), readings.end(), [&plan](const auto& point) {
      return point.second == plan.averages;
    })) << "no point is measured twice, none in part";
  } else {
    std::vector<double> encoder = angle::sweepFromSamples(samples).encoderDeg;
    std::sort(encoder.begin(), encoder.end());
    double widest = 0.0;
    for (std::size_t i = 1; i < encoder.size(); ++i) {
      widest = std::max(widest, encoder[i] - encoder[i - 1]);
    }
    EXPECT_LT(widest, 0.12) << "every sector is passed from its beginning to its end (0.045° between samples)";
  }
}

INSTANTIATE_TEST_SUITE_P(Plans, KillTest, testing::Values("stepwise", "free-running"),
                         [](const auto& tested) { return tested.index == 0 ? "Stepwise" : "FreeRunning"; });

} // namespace
} // namespace straightedge
