// Free-running capture on a shaft that is turned by hand, and of instruments with a rate of their own: which samples
// count, what is missing, what is said.
#include "devices/capture/angle_capture.h"
#include "devices/capture/stream_pass.h"
#include "devices/instruments/bench_connection.h"
#include "devices/simulated/bench_clock.h"
#include "tests/devices/memory_sink.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <map>
#include <semaphore>
#include <thread>
#include <utility>
#include <vector>

namespace straightedge::devices {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

CaptureCourse courseOf(const AnglePlan& plan) { return *CaptureCourse::make(plan, {}); }

TEST(StreamPass, DrivenEverySampleFromTheFirstSectorOnHasItsPlace) {
  auto course = courseOf({.pointsPerTurn = 36, .startDeg = 5.0, .sampleRateHz = 1000.0});
  StreamPass pass(course, {.first = 0, .last = 35}, false);
  EXPECT_FALSE(pass.place(4.9));
  EXPECT_FALSE(pass.begun());
  EXPECT_EQ(pass.place(5.0), 0);
  EXPECT_EQ(pass.place(15.1), 1);
  EXPECT_EQ(pass.place(14.9), 1) << "jitter leads not back";
  EXPECT_EQ(course.done(), 1);
  EXPECT_EQ(pass.place(364.9), 35);
  EXPECT_FALSE(pass.passed());
  EXPECT_FALSE(pass.place(365.1));
  EXPECT_TRUE(pass.passed());
  EXPECT_EQ(course.done(), 36);
  EXPECT_FALSE(pass.place(100.0)) << "what comes after the end belongs to nothing";
  auto other = courseOf({.pointsPerTurn = 36, .sampleRateHz = 1000.0});
  StreamPass broken(other, {.first = 0, .last = 35}, false);
  EXPECT_FALSE(broken.place(std::nan("")));
  EXPECT_EQ(broken.place(12.0), 1);
  EXPECT_EQ(broken.place(std::nan("")), 1) << "to be refused where it is stored";
}

TEST(StreamPass, ByHandItBeginsBeforeTheFirstSectorAndTurningBackDoesNotCount) {
  auto course = courseOf({.pointsPerTurn = 36, .sampleRateHz = 1000.0});
  StreamPass pass(course, {.first = 0, .last = 35}, true);
  EXPECT_FALSE(pass.place(200.0)) << "wherever the shaft stands at first";
  EXPECT_FALSE(pass.begun());
  EXPECT_FALSE(pass.place(-0.1));
  EXPECT_EQ(pass.place(0.1), 0);
  EXPECT_EQ(pass.place(12.0), 1);
  EXPECT_EQ(pass.place(11.7), 1) << "a trembling hand";
  EXPECT_FALSE(pass.place(11.4)) << "turned back";
  EXPECT_FALSE(pass.place(11.9)) << "and not yet come on again";
  EXPECT_EQ(pass.place(12.1), 1);
}

TEST(StreamPass, BackwardsItIsTheSameTheOtherWay) {
  auto course = courseOf({.pointsPerTurn = 36, .bothDirections = true, .sampleRateHz = 1000.0});
  StreamPass pass(course, {.first = 36, .last = 71}, true);
  EXPECT_DOUBLE_EQ(pass.fromDeg(), 350.0);
  EXPECT_DOUBLE_EQ(pass.toDeg(), -10.0);
  EXPECT_FALSE(pass.place(349.0));
  EXPECT_FALSE(pass.place(351.0));
  EXPECT_EQ(pass.place(349.0), 36);
  EXPECT_FALSE(pass.place(349.6)) << "turned back";
  EXPECT_EQ(pass.place(-9.9), 71);
  EXPECT_FALSE(pass.place(-10.1));
  EXPECT_TRUE(pass.passed());
}

/// Gives 5 samples at each look, 2 ms apart on the virtual clock, of a shaft that is turned 0.1° between two samples,
/// from `fromDeg` on. Hooks are called before the block of their number, from 1, and may change it.
class HandTurnedStream : public AngleStream, public BenchConnection {
public:
  using Hook = std::function<Result<void>(StreamBlock&)>;
  explicit HandTurnedStream(double fromDeg) : m_angleDeg(fromDeg) {}
  void at(int block, Hook hook) { m_hooks[block] = std::move(hook); }

  Result<void> start(const StreamRequest& request) override {
    requests.push_back(request);
    m_angleDeg -= std::exchange(m_turnsBackDeg, 0.0);
    return {};
  }
  Result<StreamBlock> read() override {
    StreamBlock block;
    for (int i = 0; i < 5; ++i) {
      m_angleDeg += 0.1;
      m_timeS += 0.002;
      block.samples.push_back({m_timeS, m_angleDeg, wrapped(m_angleDeg)});
    }
    if (const auto hook = m_hooks.find(++m_blocks); hook != m_hooks.end()) {
      if (auto done = hook->second(block); !done) {
        return std::unexpected(done.error());
      }
    }
    return block;
  }
  Result<void> stop() override {
    ++stops;
    return {};
  }
  std::optional<TransportFault> lastFault() const override { return fault; }
  Result<bool> restore() override {
    fault.reset();
    ++opened;
    m_turnsBackDeg = 60.0; // before it is gone on with
    return true;
  }
  void turn(double byDeg) { m_angleDeg += byDeg; }
  double angleDeg() const { return m_angleDeg; }

  std::vector<StreamRequest> requests;
  int opened = 1;
  int stops = 0;
  std::optional<TransportFault> fault;

private:
  static double wrapped(double angleDeg) { return angleDeg - 360.0 * std::floor(angleDeg / 360.0); }

  double m_angleDeg;
  double m_turnsBackDeg = 0.0;
  double m_timeS = 0.0;
  int m_blocks = 0;
  std::map<int, Hook> m_hooks;
};

struct NoAngle : AngleSensor, AngleReference {
  InstrumentIdentity identity() const override { return {}; }
  Result<TimedReading> readDeg() override { return fail(ErrorKind::Instrument, "no single readings here", ""); }
};

/// Counts from where it was switched on, and can be read singly while the stream stands.
struct CountingAngle : NoAngle {
  explicit CountingAngle(const HandTurnedStream& turned) : shaft(turned) {}
  Result<TimedReading> readDeg() override { return TimedReading{shaft.angleDeg(), 0.0}; }
  std::optional<double> incrementDeg() const override { return 0.01; }
  int timesOpened() const override { return shaft.opened; }
  const HandTurnedStream& shaft;
};

class StreamCapture : public testing::Test {
protected:
  AngleBench bench() {
    return {.name = "desk",
            .sensor = m_angle,
            .reference = m_angle,
            .stage = nullptr,
            .thermometer = nullptr,
            .stream = &m_stream,
            .clock = &m_clock,
            .connection = &m_stream};
  }
  CaptureProgress captured(const AnglePlan& plan) {
    AngleCapture capture(bench(), m_sink);
    const auto started = capture.start(plan);
    EXPECT_TRUE(started) << (started ? "" : started.error().message());
    for (;;) { // a fault that waits for its instrument goes on by itself
      const CaptureProgress progress = capture.progress();
      if (!progress.note.empty() && (m_notes.empty() || m_notes.back() != progress.note)) {
        m_notes.push_back(progress.note);
      }
      if (progress.state != CaptureState::Running && !progress.waitsForInstrument) {
        return progress;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  /// Every sample in its sector and number; the angles from 0° to 360°, 0.1° apart.
  void expectWhole() const {
    const auto samples = m_sink.committed();
    ASSERT_EQ(samples.size(), 3600U);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      ASSERT_EQ(samples[i].point, static_cast<int>(samples[i].encoderDeg / 30.0)) << i;
    }
  }

  VirtualClock m_clock;
  NoAngle m_none;
  NoAngle* m_angle = &m_none;
  HandTurnedStream m_stream{-20.05};
  tests::MemorySink m_sink;
  std::vector<std::string> m_notes;
  const AnglePlan m_plan{.pointsPerTurn = 12, .sampleRateHz = 500.0};
};

TEST_F(StreamCapture, WithoutAStageTheShaftIsTurnedByHand) {
  AnglePlan plan = m_plan;
  plan.pairing.maxAgeS = 0.025;
  const auto progress = captured(plan);
  EXPECT_EQ(progress.state, CaptureState::Finished);
  EXPECT_EQ(progress.note, "") << "500 Hz are 500 Hz";
  EXPECT_THAT(m_sink.gaps(), IsEmpty());
  EXPECT_EQ(m_stream.stops, 1);
  ASSERT_EQ(m_stream.requests.size(), 1U);
  EXPECT_DOUBLE_EQ(m_stream.requests[0].rateHz, 500.0);
  EXPECT_DOUBLE_EQ(m_stream.requests[0].pairing.maxAgeS, 0.025);
  expectWhole();
}

TEST_F(StreamCapture, WhatIsToBeDoneIsSaidUntilTheShaftHasCome) {
  std::binary_semaphore seen(0);
  m_stream.at(2, [&seen](StreamBlock&) -> Result<void> {
    seen.acquire();
    return {};
  });
  AngleCapture capture(bench(), m_sink);
  ASSERT_TRUE(capture.start(m_plan));
  while (capture.progress().note.empty()) { // the test's time-out ends it otherwise
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_EQ(capture.progress().note, "turn the shaft to below 0°, then steadily to 360°");
  seen.release();
  capture.waitUntilDone();
  EXPECT_EQ(capture.progress().note, "");
}

TEST_F(StreamCapture, AnotherRateThanThePlansIsSaid) {
  AnglePlan plan = m_plan;
  plan.sampleRateHz = 10000.0;
  const auto progress = captured(plan);
  EXPECT_EQ(progress.state, CaptureState::Finished);
  EXPECT_EQ(progress.note, "the bench samples 500 times a second instead of the plan's 10000: its instruments have a "
                           "rate of their own; every sample is stored");
  expectWhole();
}

TEST_F(StreamCapture, WhatMadeNoSampleIsAGapWithItsReason) {
  const auto spoil = [](std::int64_t lost, std::int64_t rejected, std::int64_t unpaired) {
    return [=](StreamBlock& block) -> Result<void> {
      block.lost = lost;
      block.rejected = rejected;
      block.unpaired = unpaired;
      return {};
    };
  };
  m_stream.at(10, spoil(3, 3, 3)); // before the first sector nothing is missing
  m_stream.at(41, spoil(0, 1, 0)); // the look in which it is reached
  m_stream.at(100, spoil(0, 2, 0));
  m_stream.at(200, spoil(4, 0, 5));
  EXPECT_EQ(captured(m_plan).state, CaptureState::Finished);
  std::vector<std::string> gaps;
  std::int64_t missing = 0;
  for (const auto& gap : m_sink.gaps()) {
    gaps.push_back(std::to_string(gap.count) + ": " + gap.reason);
    missing += gap.count;
  }
  EXPECT_THAT(gaps, ElementsAre("1: what the instrument sent was no reading",
                                "2: what the instrument sent was no reading", "4: the instrument's memory ran over",
                                "5: no reading of the sensor close enough to the encoder's in time"));
  expectWhole();
  EXPECT_EQ(m_sink.committed().back().sequence, 3599 + missing) << "numbers are used up for them";
}

TEST_F(StreamCapture, UnpluggedInTheMiddleItKeepsAllAndPassesTheBrokenSectorAgain) {
  m_stream.at(300, [this](StreamBlock&) -> Result<void> { // at 129.95°, in the sector from 120°
    m_stream.fault = TransportFault::Gone;
    return fail(ErrorKind::Instrument, "the instrument is gone", "plug it in again");
  });
  const auto progress = captured(m_plan);
  EXPECT_EQ(progress.state, CaptureState::Finished);
  EXPECT_EQ(m_stream.requests.size(), 2U) << "started again";
  const auto samples = m_sink.committed();
  std::vector<int> perSector(12, 0);
  std::vector<int> firstTry(12, 0);
  for (const auto& sample : samples) {
    (sample.attempt == 0 && sample.point == 4 ? firstTry : perSector)[static_cast<std::size_t>(sample.point)]++;
  }
  EXPECT_THAT(perSector, testing::Each(300));
  EXPECT_EQ(firstTry[4], 95) << "what came before the fault is kept";
}

TEST_F(StreamCapture, AnEncoderThatIsBackIsComparedWithWhatItReadLastAlsoWhereThatWasNotStored) {
  CountingAngle counting(m_stream);
  m_angle = &counting;
  m_stream.at(300, [this](StreamBlock&) -> Result<void> {
    m_stream.turn(-3.0); // the five samples after this one lie behind the farthest: they belong to nothing
    return {};
  });
  m_stream.at(302, [this](StreamBlock&) -> Result<void> {
    m_stream.turn(-0.5); // the shaft stands where it was read last
    m_stream.fault = TransportFault::Gone;
    return fail(ErrorKind::Instrument, "the instrument is gone", "plug it in again");
  });
  const auto progress = captured(m_plan);
  EXPECT_EQ(progress.state, CaptureState::Finished) << (progress.error ? progress.error->message() : "");
  EXPECT_EQ(m_stream.opened, 2);
}

TEST_F(StreamCapture, SilenceIsTriedAgainAsThePlanSaysAndThenTold) {
  for (const int block : {300, 301, 302}) {
    m_stream.at(block, [this](StreamBlock&) -> Result<void> {
      m_stream.fault = TransportFault::TimedOut;
      return fail(ErrorKind::Instrument, "nothing came for 3 s", "check the cable");
    });
  }
  AnglePlan plan = m_plan;
  plan.retries = 2;
  const auto progress = captured(plan);
  EXPECT_EQ(progress.state, CaptureState::Paused);
  EXPECT_EQ(progress.retried, 2);
  EXPECT_EQ(m_stream.requests.size(), 3U);
  ASSERT_TRUE(progress.error);
  EXPECT_THAT(progress.error->message(), HasSubstr("nothing came for 3 s"));
}

} // namespace
} // namespace straightedge::devices
