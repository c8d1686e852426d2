// Pause, stop, redo, resume and everything that goes wrong on the way: nothing is lost, nothing is made up.
#include "core/angle/session_sweep.h"
#include "devices/capture/angle_capture.h"
#include "devices/simulated/simulated_angle_bench.h"
#include "tests/devices/faulty_instruments.h"
#include "tests/devices/memory_sink.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <semaphore>
#include <set>
#include <thread>

namespace straightedge::devices {
namespace {

using testing::HasSubstr;

class CaptureControlTest : public testing::Test {
protected:
  static SimulatedAngleSettings virtualTime() {
    SimulatedAngleSettings settings;
    settings.realTime = false;
    return settings;
  }
  AngleBench bench() {
    AngleBench bench = m_bench.bench();
    bench.sensor = &m_sensor;
    bench.stream = &m_stream;
    return bench;
  }
  static void waitFor(const AngleCapture& capture, CaptureState state) {
    while (capture.progress().state != state) { // the test's time-out ends it otherwise
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  /// Holds the capture thread in a hook while the controlling thread acts.
  struct Meeting {
    std::binary_semaphore reached{0};
    std::binary_semaphore goOn{0};
    void hold() {
      reached.release();
      goOn.acquire();
    }
  };
  void expectEachPointOnce(const AnglePlan& plan) const {
    const auto samples = m_sink.committed();
    ASSERT_EQ(samples.size(), plannedPoints(plan).size() * static_cast<std::size_t>(plan.averages));
    for (std::size_t i = 0; i < samples.size(); ++i) {
      EXPECT_EQ(samples[i].sequence, static_cast<std::int64_t>(i));
      EXPECT_EQ(samples[i].point, static_cast<int>(i) / plan.averages);
      EXPECT_EQ(samples[i].attempt, 0);
      EXPECT_TRUE(i == 0 || samples[i].timeS > samples[i - 1].timeS) << i;
    }
  }
  /// Latest attempt of every sector: from its beginning to its end, without a hole.
  void expectSectorsCovered(const AnglePlan& plan) const {
    const angle::Sweep sweep = angle::sweepFromSamples(m_sink.committed());
    const double spacing = 360.0 / plan.sampleRateHz; // at 360°/s
    std::vector<double> encoder = sweep.encoderDeg;
    std::sort(encoder.begin(), encoder.end());
    EXPECT_LE(encoder.front() - plan.startDeg, spacing);
    EXPECT_GE(encoder.back() - plan.startDeg, 360.0 * plan.turns - spacing);
    for (std::size_t i = 1; i < encoder.size(); ++i) {
      EXPECT_LT(encoder[i] - encoder[i - 1], 1.5 * spacing) << "at " << encoder[i];
    }
    std::set<std::int64_t> numbers;
    for (const auto& sample : m_sink.committed()) {
      numbers.insert(sample.sequence);
    }
    EXPECT_EQ(numbers.size(), m_sink.committed().size());
    EXPECT_EQ(*numbers.rbegin(), static_cast<std::int64_t>(numbers.size()) - 1) << "no number is left out";
  }

  SimulatedAngleBench m_bench{virtualTime()};
  tests::HookedSensor m_sensor{*m_bench.bench().sensor};
  tests::HookedStream m_stream{*m_bench.bench().stream};
  tests::MemorySink m_sink;
  const AnglePlan m_plan{.pointsPerTurn = 16, .bothDirections = true, .averages = 3};
  const AnglePlan m_freeRunning{.pointsPerTurn = 12, .sampleRateHz = 2000.0};
};

TEST_F(CaptureControlTest, PausesInTheMiddleOfAPointAndGoesOn) {
  AngleCapture capture(bench(), m_sink);
  m_sensor.at(20, [&capture] {
    capture.pause();
    return std::nullopt;
  });
  ASSERT_TRUE(capture.start(m_plan));
  waitFor(capture, CaptureState::Paused);
  EXPECT_FALSE(capture.progress().error);
  EXPECT_EQ(m_sink.committed().size(), 20U) << "everything is committed while paused";
  EXPECT_FALSE(capture.start(m_plan)) << "runs already";
  capture.resume();
  capture.waitUntilDone();
  EXPECT_EQ(capture.progress().state, CaptureState::Finished);
  expectEachPointOnce(m_plan);
}

TEST_F(CaptureControlTest, AFaultPausesAndResumeTriesThePointAgain) {
  AngleCapture capture(bench(), m_sink);
  m_sensor.failAt(8, "no answer within 0.5 s");
  m_sensor.failAt(9, "no answer within 0.5 s");
  ASSERT_TRUE(capture.start(m_plan));
  for (int fault = 0; fault < 2; ++fault) {
    capture.waitUntilDone();
    const CaptureProgress progress = capture.progress();
    ASSERT_EQ(progress.state, CaptureState::Paused);
    ASSERT_TRUE(progress.error);
    EXPECT_EQ(progress.error->kind, ErrorKind::Instrument);
    EXPECT_EQ(progress.error->message(), "sensor: no answer within 0.5 s; see to its cable");
    EXPECT_EQ(m_sink.committed().size(), 7U) << "what was read is stored, and nothing else";
    capture.resume();
  }
  capture.waitUntilDone();
  EXPECT_EQ(capture.progress().state, CaptureState::Finished);
  EXPECT_FALSE(capture.progress().error);
  expectEachPointOnce(m_plan);
}

TEST_F(CaptureControlTest, ReadingsThatAreNoAnglesAreNotStored) {
  for (const double value :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -0.5, 361.0}) {
    tests::MemorySink sink;
    tests::HookedSensor sensor(*m_bench.bench().sensor);
    sensor.at(3, [value] { return Result<TimedReading>(TimedReading{value, 1.0}); });
    AngleBench bench = m_bench.bench();
    bench.sensor = &sensor;
    AngleCapture capture(bench, sink);
    ASSERT_TRUE(capture.start(m_plan));
    capture.waitUntilDone();
    ASSERT_EQ(capture.progress().state, CaptureState::Paused);
    EXPECT_THAT(capture.progress().error->message(), HasSubstr("a reading is not an angle from 0 to 360°"));
    EXPECT_EQ(sink.committed().size(), 2U);
  }
}

TEST_F(CaptureControlTest, AReadingOfExactly360IsStoredAs0) {
  m_sensor.at(1, [] { return Result<TimedReading>(TimedReading{360.0, 0.1}); });
  AngleCapture capture(bench(), m_sink);
  ASSERT_TRUE(capture.start(m_plan));
  capture.waitUntilDone();
  EXPECT_EQ(m_sink.committed().front().sensorDeg, 0.0);
}

TEST_F(CaptureControlTest, ASinkThatFailsEndsTheCaptureWithItsError) {
  m_sink.failAfter(40);
  AngleCapture capture(bench(), m_sink);
  ASSERT_TRUE(capture.start(m_plan));
  capture.waitUntilDone();
  const CaptureProgress progress = capture.progress();
  EXPECT_EQ(progress.state, CaptureState::Failed);
  ASSERT_TRUE(progress.error);
  EXPECT_EQ(progress.error->message(), "test.sedge: the disk is full; free some space");
  EXPECT_EQ(capture.takeNewSamples().size(), 40U) << "what the sink refused is not shown as captured";
}

TEST_F(CaptureControlTest, AStoppedSweepIsResumedWithoutRepeatingAnything) {
  {
    AngleCapture capture(bench(), m_sink);
    Meeting meeting;
    m_sensor.at(47, [&meeting] {
      meeting.hold();
      return std::nullopt;
    });
    ASSERT_TRUE(capture.start(m_plan));
    meeting.reached.acquire();
    capture.stop();
    meeting.goOn.release();
    capture.waitUntilDone();
    EXPECT_EQ(capture.progress().state, CaptureState::Stopped);
  }
  ASSERT_EQ(m_sink.committed().size(), 47U) << "47 = 15 points of 3 readings and 2 of the next";
  AngleCapture capture(bench(), m_sink);
  ASSERT_TRUE(capture.start(m_plan, m_sink.committed()));
  EXPECT_GE(capture.progress().pointsDone, 15);
  capture.waitUntilDone();
  EXPECT_EQ(capture.progress().state, CaptureState::Finished);
  EXPECT_EQ(capture.progress().pointsDone, 32);
  expectEachPointOnce(m_plan);

  AngleCapture nothingLeft(bench(), m_sink);
  ASSERT_TRUE(nothingLeft.start(m_plan, m_sink.committed()));
  nothingLeft.waitUntilDone();
  EXPECT_EQ(nothingLeft.progress().state, CaptureState::Finished);
  expectEachPointOnce(m_plan);
}

TEST_F(CaptureControlTest, SamplesOfAnotherPlanAreRefused) {
  AngleCapture capture(bench(), m_sink);
  ASSERT_TRUE(capture.start(m_plan));
  capture.waitUntilDone();
  const auto started = capture.start({.pointsPerTurn = 16}, m_sink.committed());
  ASSERT_FALSE(started);
  EXPECT_EQ(started.error().kind, ErrorKind::Usage);
  EXPECT_THAT(started.error().message(), HasSubstr("sample 48 does not belong to this plan; go on with the plan that "
                                                   "the sweep was begun with, or start it over"));
}

TEST_F(CaptureControlTest, RedoWhileRunningAndAfterwardsCountsTheLatestAttemptOnly) {
  AngleCapture capture(bench(), m_sink);
  m_sensor.at(30, [&capture] {
    capture.redo(3);
    capture.redo(99); // no such point
    return std::nullopt;
  });
  ASSERT_TRUE(capture.start(m_plan));
  capture.waitUntilDone();
  ASSERT_EQ(capture.progress().state, CaptureState::Finished);
  EXPECT_EQ(m_sink.committed().size(), 99U);
  capture.redo(3);
  capture.redo(20);
  capture.waitUntilDone();
  const auto samples = m_sink.committed();
  ASSERT_EQ(samples.size(), 105U);
  std::map<int, int> latest;
  for (const auto& sample : samples) {
    latest[sample.point] = std::max(latest[sample.point], sample.attempt);
  }
  EXPECT_EQ(latest[3], 2);
  EXPECT_EQ(latest[20], 1);
  EXPECT_EQ(latest[4], 0);
  const angle::Sweep sweep = angle::sweepFromSamples(samples);
  EXPECT_EQ(sweep.size(), 96U);
  const auto last = std::find_if(samples.begin(), samples.end(),
                                 [](const auto& sample) { return sample.point == 3 && sample.attempt == 2; });
  EXPECT_EQ(sweep.encoderDeg[9], last->encoderDeg) << "the last measurement of point 3, in its place";
  EXPECT_EQ(sweep.sensorDeg[9], last->sensorDeg);

  AngleCapture other(bench(), m_sink);
  other.redo(5);
  ASSERT_TRUE(other.start(m_plan, samples));
  other.waitUntilDone();
  EXPECT_EQ(m_sink.committed().size(), 108U) << "asked for before the start";
  EXPECT_EQ(m_sink.committed().back().point, 5);
  EXPECT_EQ(m_sink.committed().back().attempt, 1);
}

TEST_F(CaptureControlTest, FreeRunningPausesAndPassesTheBrokenSectorAgain) {
  AngleCapture capture(bench(), m_sink);
  m_stream.at(80, [&capture](StreamBlock&) { capture.pause(); });
  ASSERT_TRUE(capture.start(m_freeRunning));
  waitFor(capture, CaptureState::Paused);
  const int doneBefore = capture.progress().pointsDone;
  EXPECT_GT(doneBefore, 2);
  EXPECT_LT(doneBefore, 12);
  capture.resume();
  capture.waitUntilDone();
  EXPECT_EQ(capture.progress().state, CaptureState::Finished);
  expectSectorsCovered(m_freeRunning);
}

TEST_F(CaptureControlTest, FreeRunningIsResumedFromWhatIsStored) {
  {
    AngleCapture capture(bench(), m_sink);
    Meeting meeting;
    m_stream.at(100, [&meeting](StreamBlock&) { meeting.hold(); });
    ASSERT_TRUE(capture.start(m_freeRunning));
    meeting.reached.acquire();
    capture.stop();
    meeting.goOn.release();
    capture.waitUntilDone();
    ASSERT_EQ(capture.progress().state, CaptureState::Stopped);
  }
  const auto before = m_sink.committed().size();
  AngleCapture capture(bench(), m_sink);
  ASSERT_TRUE(capture.start(m_freeRunning, m_sink.committed()));
  capture.waitUntilDone();
  expectSectorsCovered(m_freeRunning);
  EXPECT_LT(m_sink.committed().size(), before + 2000U) << "whole sectors are not passed again";
  const auto after = m_sink.committed().size();
  AngleCapture nothingLeft(bench(), m_sink);
  ASSERT_TRUE(nothingLeft.start(m_freeRunning, m_sink.committed()));
  nothingLeft.waitUntilDone();
  EXPECT_EQ(m_sink.committed().size(), after);
}

TEST_F(CaptureControlTest, WhatTheInstrumentLostIsRecordedWithItsNumbers) {
  m_stream.at(60, [](StreamBlock& block) { block.lost = 7; });
  AngleCapture capture(bench(), m_sink);
  ASSERT_TRUE(capture.start(m_freeRunning));
  capture.waitUntilDone();
  ASSERT_EQ(m_sink.gaps().size(), 1U);
  const session::SampleGap gap = m_sink.gaps().front();
  EXPECT_EQ(gap.count, 7);
  EXPECT_EQ(gap.reason, "the instrument's memory ran over");
  std::set<std::int64_t> numbers;
  for (const auto& sample : m_sink.committed()) {
    numbers.insert(sample.sequence);
  }
  for (std::int64_t number = 0; number <= *numbers.rbegin(); ++number) {
    const bool missing = number >= gap.firstMissing && number < gap.firstMissing + gap.count;
    EXPECT_EQ(numbers.contains(number), !missing) << number;
  }
}

TEST_F(CaptureControlTest, ADisplayThatNeverLooksLosesNothingOfWhatIsStored) {
  AngleCapture capture(bench(), m_sink);
  const AnglePlan plan{.pointsPerTurn = 36, .turns = 15, .sampleRateHz = 10000.0};
  ASSERT_TRUE(capture.start(plan));
  capture.waitUntilDone();
  const CaptureProgress progress = capture.progress();
  const auto shown = static_cast<std::int64_t>(capture.takeNewSamples().size());
  EXPECT_NEAR(static_cast<double>(progress.samples), 150000.0, 30.0);
  EXPECT_GT(progress.samplesLost, 0);
  EXPECT_EQ(shown + progress.samplesLost, progress.samples);
  EXPECT_EQ(static_cast<std::int64_t>(m_sink.committed().size()), progress.samples);
}

TEST_F(CaptureControlTest, ABenchThatCannotStreamSaysSo) {
  AngleBench poor = bench();
  poor.stream = nullptr;
  AngleCapture capture(poor, m_sink);
  const auto started = capture.start(m_freeRunning);
  ASSERT_FALSE(started);
  EXPECT_EQ(started.error().message(), "Simulated bench: this bench cannot sample while the shaft turns; set the "
                                       "sample rate to 0 to capture point by point");
  poor.sensor = nullptr;
  AngleCapture blind(poor, m_sink);
  EXPECT_EQ(blind.start(m_plan).error().kind, ErrorKind::Instrument);
}

/// Somebody who turns the shaft by hand: 5° further whenever the capture waits, resting a while at each place.
class HandClock : public BenchClock {
public:
  explicit HandClock(AngleBench bench) : m_bench(std::move(bench)) {}
  double nowS() const override { return m_bench.clock->nowS(); }
  void sleepS(double seconds) override {
    m_bench.clock->sleepS(seconds);
    if (++m_sleeps % 8 == 0) {
      std::ignore = m_bench.stage->moveToDeg(5.0 * (m_sleeps / 8));
    }
  }

private:
  AngleBench m_bench;
  int m_sleeps = 0;
};

TEST_F(CaptureControlTest, AShaftTurnedByHandIsMeasuredWhereItRests) {
  HandClock clock(m_bench.bench());
  AngleBench byHand = bench();
  byHand.stage = nullptr;
  byHand.clock = &clock;
  AngleCapture capture(byHand, m_sink);
  const AnglePlan plan{.pointsPerTurn = 12, .startDeg = 30.0};
  ASSERT_TRUE(capture.start(plan));
  capture.waitUntilDone();
  const auto samples = m_sink.committed();
  ASSERT_EQ(samples.size(), 12U);
  for (const auto& sample : samples) {
    EXPECT_NEAR(sample.encoderDeg, 30.0 + 30.0 * sample.point, 7.5);
  }
}

} // namespace
} // namespace straightedge::devices
