// capture angle from its command line to session and CSV.
#include "app/cli/capture_command.h"
#include "core/angle/session_sweep.h"
#include "core/angle/sweep_csv.h"
#include "core/session/session.h"
#include "tests/core/session/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <sstream>
#include <thread>

namespace straightedge::cli {
namespace {

using session::Session;
using session::SweepRole;
using testing::HasSubstr;

class CaptureCommandTest : public testing::Test {
protected:
  tests::TemporaryFolder m_folder;
  std::string m_session = (m_folder / "a.sedge").string();

  Result<void> run(const std::string& options) {
    CLI::App program;
    std::function<Result<void>()> chosen;
    addCaptureCommand(program, [&chosen](std::function<Result<void>()> run) { chosen = std::move(run); });
    std::istringstream words("capture angle --bench simulated --session " + m_session + " " + options);
    std::vector<std::string> arguments{std::istream_iterator<std::string>(words), {}};
    std::reverse(arguments.begin(), arguments.end());
    program.parse(arguments);
    testing::internal::CaptureStdout();
    auto outcome = chosen();
    m_output = testing::internal::GetCapturedStdout();
    return outcome;
  }
  std::string m_output;
};

TEST_F(CaptureCommandTest, CapturesIntoASessionAndACsvOfTheSameSweep) {
  const std::string csv = (m_folder / "a.csv").string();
  const auto outcome = run("--points 32 --turns 2 --both-directions --averages 2 --seed 5 --serial S1 --operator Me "
                           "--csv " +
                           csv);
  ASSERT_TRUE(outcome) << outcome.error().message();
  EXPECT_EQ(m_output, m_session + ": 128 points, 256 samples\n");
  const auto fromSession = angle::readSessionSweep(m_session, SweepRole::Calibration);
  ASSERT_TRUE(fromSession) << fromSession.error().message();
  const auto fromCsv = angle::readSweepCsv(csv);
  ASSERT_TRUE(fromCsv) << fromCsv.error().message();
  EXPECT_EQ(fromSession->sweep.size(), 256U);
  EXPECT_EQ(fromSession->sweep.encoderDeg, fromCsv->encoderDeg);
  EXPECT_EQ(fromSession->sweep.sensorDeg, fromCsv->sensorDeg);
  EXPECT_EQ(fromSession->sweep.direction, fromCsv->direction);
  EXPECT_EQ(fromSession->sweep.turn, fromCsv->turn);
  EXPECT_EQ(fromSession->sweep.temperatureC, fromCsv->temperatureC);
  EXPECT_EQ(fromSession->sweep.source.sha256, fromCsv->source.sha256) << "the CSV is the canonical one";
  EXPECT_EQ(fromSession->traceability.deviceSerial, "S1");
  EXPECT_EQ(fromSession->traceability.operatorName, "Me");
  EXPECT_EQ(fromSession->traceability.reference.model, "Simulated encoder");
  EXPECT_TRUE(fromSession->traceability.ambientC.has_value());
}

TEST_F(CaptureCommandTest, ASeedRepeatsARun) {
  std::vector<std::vector<double>> readings;
  for (const char* seed : {"7", "7", "8"}) {
    std::filesystem::remove(m_session);
    ASSERT_TRUE(run(std::string("--seed ") + seed));
    readings.push_back(angle::readSessionSweep(m_session, SweepRole::Calibration)->sweep.sensorDeg);
  }
  EXPECT_EQ(readings[0], readings[1]);
  EXPECT_NE(readings[0], readings[2]);
}

TEST_F(CaptureCommandTest, DoesNotTouchAFileThatExists) {
  ASSERT_TRUE(run("--points 8"));
  const auto outcome = run("--points 8");
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().kind, ErrorKind::Storage);
  EXPECT_EQ(outcome.error().message(),
            m_session + ": the file exists already; give --resume to go on with it, or choose another name");
}

TEST_F(CaptureCommandTest, AddsAVerificationSweepWithFreshNoise) {
  ASSERT_TRUE(run("--points 32 --seed 3"));
  ASSERT_TRUE(run("--verification --points 32"));
  const auto calibration = angle::readSessionSweep(m_session, SweepRole::Calibration);
  const auto verification = angle::readSessionSweep(m_session, SweepRole::Verification);
  ASSERT_TRUE(calibration && verification);
  EXPECT_EQ(calibration->sweep.size(), verification->sweep.size());
  EXPECT_NE(calibration->sweep.sensorDeg, verification->sweep.sensorDeg);
  const auto again = run("--verification");
  ASSERT_FALSE(again);
  EXPECT_THAT(again.error().message(), HasSubstr("holds a verification sweep already; give --resume"));
}

TEST_F(CaptureCommandTest, SigintStopsCleanlyAndResumeEndsTheSweep) {
  std::thread impatient([] {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    ::kill(::getpid(), SIGINT);
  });
  const auto outcome = run("--points 400 --settle 0.01 --real-time");
  impatient.join();
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().kind, ErrorKind::Cancelled);
  EXPECT_EQ(exitCode(outcome.error().kind), 130);
  EXPECT_THAT(outcome.error().message(), HasSubstr("of 400 points; everything taken is stored; go on with --resume"));

  const auto other = run("--resume --points 200");
  ASSERT_FALSE(other);
  EXPECT_EQ(other.error().kind, ErrorKind::Usage);
  EXPECT_THAT(other.error().message(), HasSubstr("the sweep was begun with another plan"));

  const auto resumed = run("--resume");
  ASSERT_TRUE(resumed) << resumed.error().message();
  const auto samples = (*Session::openReadOnly(m_session))->angleSamples(SweepRole::Calibration);
  ASSERT_EQ(samples->size(), 400U);
  for (std::size_t i = 0; i < samples->size(); ++i) {
    EXPECT_EQ((*samples)[i].sequence, static_cast<std::int64_t>(i));
    EXPECT_EQ((*samples)[i].point, static_cast<int>(i));
  }
}

TEST_F(CaptureCommandTest, RefusesWhatItCannotDo) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"--points 4", "the number of points per turn is 4; give 8 to 36000"},
      {"--settle -1", "the settling time is -1 s; give 0 to 600 s"},
      {"--rate 0.5", "the sample rate is 0.5 Hz"},
      {"--noise -1", "--noise is -1; give 0 to 90 degrees"},
      {"--bits 3", "--bits is 3; give 4 to 32, or 0 for no quantisation"},
  };
  for (const auto& [options, message] : cases) {
    const auto outcome = run(options);
    ASSERT_FALSE(outcome) << options;
    EXPECT_EQ(outcome.error().kind, ErrorKind::Usage) << options;
    EXPECT_THAT(outcome.error().message(), HasSubstr(message));
    EXPECT_FALSE(std::filesystem::exists(m_session)) << "a refused run leaves no file: " << options;
  }
  const auto missing = run("--resume");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().kind, ErrorKind::Input);
  EXPECT_THAT(missing.error().message(), HasSubstr("there is no such file"));
}

TEST_F(CaptureCommandTest, KnowsItsBenches) {
  CaptureRequest request;
  request.bench = "bench 7";
  request.session = m_session;
  const auto outcome = runCapture(request);
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().kind, ErrorKind::Instrument);
  EXPECT_THAT(outcome.error().message(), HasSubstr("there is no bench named 'bench 7'; give --bench simulated, or"));
}

} // namespace
} // namespace straightedge::cli
