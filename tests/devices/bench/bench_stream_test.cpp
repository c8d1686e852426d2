// Opened benches that stream, on emulated instruments: one board that prints both angles, and an encoder reader with a
// board that prints the sensor's. Every sample is there once, what was none is a gap, and a plug pulled loses nothing.
#include "devices/bench/opened_bench.h"
#include "devices/capture/angle_capture.h"
#include "tests/devices/memory_sink.h"
#include "tests/fakes/usb/byte_stream_devices.h"
#include "tests/fakes/usb/emulated_usb.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <thread>

namespace straightedge::fakes {
namespace {

using devices::AngleCapture;
using devices::AnglePlan;
using devices::CaptureProgress;
using devices::CaptureState;
using devices::InstrumentRole;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr int linesPerDegree = 10;

/// A shaft that somebody turns: it stands until `turning`, then goes on by 0.1° with every line of the board.
struct TurnedShaft {
  std::atomic<bool> turning = false;
  std::atomic<int> line = -5 * linesPerDegree;
  int next() { return turning && line < 370 * linesPerDegree ? line++ : line.load(); }
};

double sensorOf(double encoderDeg) {
  const double shifted = encoderDeg + 20.0;
  return shifted - 360.0 * std::floor(shifted / 360.0);
}

/// Prints encoder and sensor, 15 lines whenever it is polled, at most once a millisecond; `spoilt`: every so many lines
/// one is garbage.
std::shared_ptr<CdcAcmDevice> boardOfBoth(TurnedShaft& shaft, int spoilt = 0) {
  auto device = std::make_shared<CdcAcmDevice>();
  device->generate([&shaft, spoilt, next = std::chrono::steady_clock::now()]() mutable {
    std::string lines;
    const auto now = std::chrono::steady_clock::now();
    if (now < next) {
      return lines;
    }
    next = now + std::chrono::milliseconds(1);
    for (int i = 0; i < 15; ++i) {
      const int line = shaft.next();
      const double encoderDeg = static_cast<double>(line) / linesPerDegree;
      std::array<char, 48> text{};
      if (spoilt > 0 && line > 0 && line < 360 * linesPerDegree && line % spoilt == 0) {
        std::snprintf(text.data(), text.size(), "nan,oops\r\n");
      } else {
        std::snprintf(text.data(), text.size(), "%.2f,%.4f\r\n", encoderDeg, sensorOf(encoderDeg));
      }
      lines += text.data();
    }
    return lines;
  });
  return device;
}

devices::BenchInstrument instrument(const std::string& id, std::vector<InstrumentRole> roles, const std::string& serial,
                                    devices::SettingValues settings) {
  return {.instrument = id,
          .roles = std::move(roles),
          .serial = serial,
          .port = {},
          .settings = std::move(settings),
          .baud = {}};
}

devices::SavedBench oneBoard() {
  return {.name = "desk",
          .instruments = {
              instrument("ascii-board", {InstrumentRole::AngleSensor, InstrumentRole::AngleReference}, "ACM-1",
                         {{"reference_column", "1"}, {"column", "2"}, {"deadline_s", "60"}, {"keeps_zero", "yes"}})}};
}

class BenchStreams : public ::testing::Test {
protected:
  void open(const devices::SavedBench& saved) {
    auto opened = devices::OpenedBench::open(saved, {});
    ASSERT_TRUE(opened) << opened.error().message();
    m_bench = *std::move(opened);
    m_roles = *m_bench->angleBench();
  }
  static void waitFor(const AngleCapture& capture, const std::function<bool(const CaptureProgress&)>& reached) {
    for (;;) { // the test's time-out ends it otherwise
      const CaptureProgress progress = capture.progress();
      const bool faulted = progress.error && !progress.waitsForInstrument;
      ASSERT_FALSE(faulted) << progress.error->message();
      if (reached(progress)) {
        return;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  static bool wantsTheShaftTurned(const CaptureProgress& progress) {
    return progress.note.starts_with("turn the shaft");
  }
  static bool hasEnded(const CaptureProgress& progress) { return progress.state == CaptureState::Finished; }

  EmulatedUsb m_bus;
  TurnedShaft m_shaft;
  std::unique_ptr<devices::OpenedBench> m_bench;
  devices::AngleBench m_roles;
  tests::MemorySink m_sink;
  const AnglePlan m_plan{.pointsPerTurn = 36, .sampleRateHz = 10000.0};
};

TEST_F(BenchStreams, EveryLineOfABoardWithBothAnglesIsASample) {
  m_bus.plug(boardOfBoth(m_shaft));
  open(oneBoard());
  ASSERT_NE(m_roles.stream, nullptr);
  AngleCapture capture(m_roles, m_sink);
  ASSERT_TRUE(capture.start(m_plan));
  waitFor(capture, wantsTheShaftTurned);
  m_shaft.turning = true;
  waitFor(capture, hasEnded);
  const auto samples = m_sink.committed();
  ASSERT_EQ(samples.size(), 3600U);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    ASSERT_EQ(std::lround(samples[i].encoderDeg * linesPerDegree), static_cast<long>(i));
    ASSERT_EQ(samples[i].point, static_cast<int>(i / 100));
    ASSERT_NEAR(samples[i].sensorDeg, sensorOf(samples[i].encoderDeg), 1e-4);
    ASSERT_TRUE(i == 0 || samples[i].timeS >= samples[i - 1].timeS);
  }
  EXPECT_THAT(m_sink.gaps(), IsEmpty());
}

TEST_F(BenchStreams, LinesThatAreNoReadingsAreGaps) {
  m_bus.plug(boardOfBoth(m_shaft, 130)); // 27 of 3,600; the last one well before the end of the sweep
  open(oneBoard());
  AngleCapture capture(m_roles, m_sink);
  ASSERT_TRUE(capture.start(m_plan));
  waitFor(capture, wantsTheShaftTurned);
  m_shaft.turning = true;
  waitFor(capture, hasEnded);
  std::int64_t missing = 0;
  for (const auto& gap : m_sink.gaps()) {
    EXPECT_EQ(gap.reason, "what the instrument sent was no reading");
    missing += gap.count;
  }
  EXPECT_EQ(missing, 27);
  EXPECT_EQ(m_sink.committed().size(), 3600U - 27U);
  EXPECT_EQ(m_sink.committed().back().sequence, 3599);
}

TEST_F(BenchStreams, UnpluggedInTheMiddleTheSweepGoesOnWhereItWas) {
  const auto board = boardOfBoth(m_shaft);
  const auto plug = m_bus.plug(board);
  open(oneBoard());
  AngleCapture capture(m_roles, m_sink);
  ASSERT_TRUE(capture.start(m_plan));
  waitFor(capture, wantsTheShaftTurned);
  m_shaft.turning = true;
  waitFor(capture, [](const CaptureProgress& progress) { return progress.pointsDone >= 12; });
  m_bus.unplug(plug);
  waitFor(capture, [](const CaptureProgress& progress) { return progress.waitsForInstrument; });
  EXPECT_THAT(capture.progress().error->message(), HasSubstr("serial ACM-1"));
  const int done = capture.progress().pointsDone;
  EXPECT_LT(done, 36);
  const auto kept = m_sink.committed();
  EXPECT_GE(kept.size(), static_cast<std::size_t>(done) * 100U) << "everything is committed while it waits";
  m_shaft.turning = false;
  m_shaft.line = done * 10 * linesPerDegree - 20; // turned back to before the sector that broke off
  m_bus.plug(boardOfBoth(m_shaft), {.port = "7"});
  waitFor(capture, wantsTheShaftTurned);
  m_shaft.turning = true;
  waitFor(capture, hasEnded);
  std::vector<int> whole(36, 0);
  std::vector<int> broken(36, 0);
  for (const auto& sample : m_sink.committed()) {
    ++(sample.point == done && sample.attempt == 0 ? broken : whole)[static_cast<std::size_t>(sample.point)];
  }
  if (std::accumulate(broken.begin(), broken.end(), 0) == 100) { // it broke off just at a border: none is passed twice
    std::swap(broken, whole);
    std::swap(broken[static_cast<std::size_t>(done)], whole[static_cast<std::size_t>(done)]);
  }
  EXPECT_THAT(whole, Each(100));
}

TEST_F(BenchStreams, EncoderReaderAndBoardArePairedAndNoReadingOfTheEncoderIsLost) {
  // Both by the same clock: the shaft turns by 90° in a second.
  using Clock = std::chrono::steady_clock;
  std::atomic<Clock::time_point> begun = Clock::time_point::max();
  const auto angleAt = [&begun](Clock::time_point time) {
    const auto passed = time - begun.load();
    return begun.load() == Clock::time_point::max() ? -5.0
                                                    : -5.0 + 90.0 * std::chrono::duration<double>(passed).count();
  };
  auto reader = std::make_shared<FtdiDevice>();
  std::atomic<bool> streaming = false;
  std::atomic<unsigned> tick = 0; // of the reader's own clock, 1/512 s
  const auto epoch = Clock::now();
  const auto timeOf = [epoch](unsigned ticks) {
    return epoch + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(ticks / 512.0));
  };
  const auto nowTicks = [epoch] {
    return static_cast<unsigned>(std::chrono::duration<double>(Clock::now() - epoch).count() * 512.0);
  };
  const auto countAt = [&](unsigned ticks) {
    return static_cast<unsigned>(static_cast<int>(std::lround(angleAt(timeOf(ticks)) * 100.0)));
  };
  const auto reply = [](char kind, const std::string& reg, unsigned data, unsigned stamp) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%c %s %08X %08X !\r\n", kind, reg.c_str(), data, stamp);
    return std::string(text.data());
  };
  reader->onLine("\r\n", [&](const std::string& line) {
    streaming = line == "S0E";
    tick = nowTicks();
    const char kind = line[0] == 'W' ? 'w' : (line[0] == 'S' ? 's' : 'r');
    return reply(kind, line.substr(1, 2), line == "R14" ? 0x12345009 : countAt(tick), tick);
  });
  reader->generate([&] {
    std::string lines;
    while (streaming && tick + 1 <= nowTicks()) {
      ++tick;
      lines += reply('s', "0E", countAt(tick), tick);
    }
    return lines;
  });
  auto board = std::make_shared<CdcAcmDevice>();
  board->generate([&, printed = Clock::now()]() mutable {
    std::string lines;
    for (; printed < Clock::now(); printed += std::chrono::milliseconds(1)) {
      lines += std::to_string(sensorOf(angleAt(printed))) + "\n";
    }
    return lines;
  });
  m_bus.plug(reader);
  m_bus.plug(board);
  open({.name = "desk",
        .instruments = {
            instrument("usdigital-qsb", {InstrumentRole::AngleReference}, "FT-1", {{"counts_per_turn", "36000"}}),
            instrument("ascii-board", {InstrumentRole::AngleSensor}, "ACM-1", {{"deadline_s", "60"}})}});
  ASSERT_NE(m_roles.stream, nullptr);
  AngleCapture capture(m_roles, m_sink);
  AnglePlan plan = m_plan;
  plan.pairing.maxAgeS = 60.0; // a busy machine must not make a pair too old
  ASSERT_TRUE(capture.start(plan));
  waitFor(capture, wantsTheShaftTurned);
  begun = Clock::now();
  waitFor(capture, hasEnded);
  EXPECT_THAT(capture.progress().note, HasSubstr("instead of the plan's 10000"));
  EXPECT_THAT(m_sink.gaps(), IsEmpty());
  const auto samples = m_sink.committed();
  ASSERT_NEAR(static_cast<double>(samples.size()), 360.0 / 90.0 * 512.0, 1.0);
  std::vector<double> apartDeg;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    apartDeg.push_back(std::abs(std::remainder(samples[i].sensorDeg - samples[i].encoderDeg - 20.0, 360.0)));
    if (i > 0) {
      const double step = samples[i].encoderDeg - samples[i - 1].encoderDeg;
      EXPECT_NEAR(step, 90.0 / 512.0, 0.011) << "none left out, at " << samples[i].encoderDeg;
    }
  }
  // For information: 10 ms between the clocks of the two are 0.9°. What is promised is tested with set times in
  // reading_pairing_test.cpp and qsb_test.cpp; here the machine may be busy, and the emulated instruments with it.
  std::ranges::sort(apartDeg);
  std::printf("pairs differ by %.2f deg in the middle, %.2f deg at most, at 90 deg/s\n", apartDeg[apartDeg.size() / 2],
              apartDeg.back());
}

/// Goes when it is told to.
struct SetClock : devices::BenchClock {
  double timeS = 0.0;
  double nowS() const override { return timeS; }
  void sleepS(double seconds) override { timeS += seconds; }
};

TEST_F(BenchStreams, AnInstrumentThatFallsSilentIsATimeOut) {
  const auto board = boardOfBoth(m_shaft);
  m_bus.plug(board);
  SetClock clock;
  auto saved = oneBoard().instruments[0];
  auto seat = devices::BenchSeat::make(saved, {}, clock);
  ASSERT_TRUE(seat);
  const auto opened = (*seat)->open([] { return devices::listDevices({}); });
  ASSERT_TRUE(opened) << opened.error().message();
  const auto stream = devices::BenchStream::make(seat->get(), seat->get(), clock);
  ASSERT_NE(stream, nullptr);
  board->generate([] { return std::string(); });
  ASSERT_TRUE(stream->start({.rateHz = 100.0}));
  while (stream->read().value().samples.size() > 0U) { // what was on its way
  }
  clock.timeS = devices::BenchStream::longestSilenceS;
  EXPECT_EQ(stream->read().value().samples.size(), 0U);
  clock.timeS += 0.001;
  const auto silent = stream->read();
  ASSERT_FALSE(silent);
  EXPECT_THAT(silent.error().message(), HasSubstr("nothing that is a reading came for 3.00 s"));
  EXPECT_EQ((*seat)->lastFault(), devices::TransportFault::TimedOut);
  ASSERT_TRUE(stream->start({.rateHz = 100.0})) << "tried again";
  EXPECT_FALSE((*seat)->lastFault());
  board->push("\n3,4\n");
  for (auto block = stream->read(); block && block->samples.empty(); block = stream->read()) {
  }
  EXPECT_FALSE((*seat)->lastFault());
}

TEST_F(BenchStreams, ABoardThatPrintsOneAngleCannotStreamTwo) {
  m_bus.plug(boardOfBoth(m_shaft));
  auto saved = oneBoard();
  saved.instruments[0].settings.erase("reference_column");
  open(saved);
  EXPECT_EQ(m_roles.stream, nullptr);
  AngleCapture capture(m_roles, m_sink);
  const auto started = capture.start(m_plan);
  ASSERT_FALSE(started);
  EXPECT_THAT(started.error().message(), HasSubstr("cannot sample while the shaft turns"));
}

} // namespace
} // namespace straightedge::fakes
