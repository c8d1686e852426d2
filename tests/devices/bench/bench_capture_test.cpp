// capture angle by the real program on an emulated QSB (FTDI) and an emulated board that prints lines (CDC-ACM), also
// when one is unplugged in the middle.
#include "tests/app/cli/child_process.h"
#include "tests/core/base/temporary_folder.h"
#include "tests/fakes/usb/byte_stream_devices.h"
#include "tests/fakes/usb/emulated_usb.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <future>
#include <numbers>
#include <thread>

namespace straightedge::fakes {
namespace {

using straightedge::testing::runCli;
using ::testing::HasSubstr;

constexpr int points = 24;
constexpr int countsPerTurn = 3600;

std::string hex8(unsigned value) {
  std::array<char, 9> text{};
  std::snprintf(text.data(), text.size(), "%08X", value);
  return text.data();
}

/// A shaft turned by hand, as the encoder's reader and the sensor see it: it stands until the reader was asked three
/// times (still, still, reading), and moves on before the fourth.
struct Shaft {
  std::atomic<int> position = 0;
  int asked = 0;
  int zeroCounts = 0; ///< of the encoder

  double angleDeg() const { return 360.0 / points * position; }
  void ask() {
    if (asked == 3) {
      ++position;
      asked = 0;
    }
    ++asked;
  }
};

/// The sensor's angle with an error that a calibration finds again.
double sensorDeg(double angleDeg) {
  const double shifted = angleDeg + 3.0 * std::sin(angleDeg * std::numbers::pi / 180.0) + 20.0;
  return shifted - 360.0 * std::floor(shifted / 360.0);
}

/// `leavesAt`: it is unplugged in the middle of its answer at this position; -1: never.
std::shared_ptr<FtdiDevice> encoderReader(Shaft& shaft, int leavesAt) {
  auto device = std::make_shared<FtdiDevice>();
  device->onLine("\r\n", [&shaft, leavesAt, raw = device.get()](const std::string& line) -> std::string {
    const std::string kind = line.substr(0, 1) == "W" ? "w " : "r ";
    const std::string reg = line.substr(1, 2);
    unsigned data = 0;
    if (line == "W0D1") { // the last of the set-up; a capture that goes on first looks whether the zero is the old one
      shaft.asked = shaft.position > 0 ? -1 : 0;
    } else if (line == "R14") {
      data = 0x12345009;
    } else if (line == "R0E") {
      shaft.ask();
      if (shaft.position == leavesAt && shaft.asked == 2) {
        raw->unplugAfter(4);
      }
      data = static_cast<unsigned>(std::lround(shaft.angleDeg() / 360.0 * countsPerTurn) - shaft.zeroCounts);
    }
    return kind + reg + " " + hex8(data) + " 00000001 !\r\n";
  });
  return device;
}

std::shared_ptr<CdcAcmDevice> sensorBoard(Shaft& shaft) {
  auto device = std::make_shared<CdcAcmDevice>();
  device->generate([&shaft, next = std::chrono::steady_clock::now()]() mutable -> std::string {
    const auto now = std::chrono::steady_clock::now();
    if (now < next) {
      return {};
    }
    next = now + std::chrono::milliseconds(2);
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4f\r\n", sensorDeg(shaft.angleDeg()));
    return text.data();
  });
  return device;
}

class BenchCapture : public ::testing::Test {
protected:
  std::string benchFile(const std::string& pairing) const {
    return m_folder.write("desk.json", R"({"format": "straightedge-bench", "version": 1, "name": "desk",
      "pairing": {"rule": ")" + pairing + R"(", "max_age_s": 10},
      "instruments": [
        {"instrument": "usdigital-qsb", "roles": ["angle-reference"], "serial": "FT-1",
         "settings": {"counts_per_turn": "3600"}},
        {"instrument": "ascii-board", "roles": ["angle-sensor"], "serial": "ACM-1",
         "settings": {"deadline_s": 60}}]})");
  }
  straightedge::testing::ChildResult capture(const std::string& pairing) const {
    return runCli({"capture", "angle", "--bench", benchFile(pairing), "--session", m_folder.file("sweep.sedge"),
                   "--csv", m_folder.file("sweep.csv"), "--points", std::to_string(points), "--settle", "0",
                   "--retries", "100"}); // a busy machine must not make a time-out a fault
  }
  straightedge::testing::ChildResult resume() const {
    return runCli({"capture", "angle", "--bench", benchFile("as-read"), "--session", m_folder.file("sweep.sedge"),
                   "--csv", m_folder.file("sweep.csv"), "--resume"});
  }
  /// In the middle the encoder's reader is unplugged and comes back; `meanwhile` is done in between.
  straightedge::testing::ChildResult captureWithReplug(const std::function<void()>& meanwhile) {
    const auto first = m_bus.plug(encoderReader(m_shaft, points / 2), {.driver = "ftdi_sio"});
    m_bus.plug(sensorBoard(m_shaft), {.driver = "cdc_acm"});
    auto child = std::async(std::launch::async, [this] { return capture("as-read"); });
    while (m_bus.isPlugged(first) && child.wait_for(std::chrono::milliseconds(1)) != std::future_status::ready) {
    }
    EXPECT_FALSE(m_bus.isPlugged(first));
    meanwhile();
    m_bus.plug(encoderReader(m_shaft, -1), {.port = "7"}); // the same one, elsewhere
    return child.get();
  }
  void expectTheSweepFits(int samples = points) const {
    const std::string csv = m_folder.read("sweep.csv");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), samples + 1) << csv;
    const auto fitted =
        runCli({"angle", "fit", m_folder.file("sweep.csv"), "--out", m_folder.path(), "--model", "harmonic:1"});
    ASSERT_EQ(fitted.code, 0) << fitted.err;
    const auto verified = runCli({"angle", "verify", m_folder.file("calibration.json"), m_folder.file("sweep.csv"),
                                  "--limit", "0.15"}); // a second harmonic of 0.08° is left: the error is not small
    EXPECT_EQ(verified.code, 0) << verified.out << verified.err;
  }

  straightedge::testing::TemporaryFolder m_folder;
  EmulatedUsb m_bus;
  Shaft m_shaft;
};

TEST_F(BenchCapture, ASweepFromAnEncoderReaderAndABoardArrivesAndFits) {
  m_bus.plug(encoderReader(m_shaft, -1), {.driver = "ftdi_sio"});
  m_bus.plug(sensorBoard(m_shaft), {.driver = "cdc_acm"});
  const auto said = capture("interpolate");
  ASSERT_EQ(said.code, 0) << said.err;
  expectTheSweepFits();
}

TEST_F(BenchCapture, UnpluggedInTheMiddleNothingIsLost) {
  const auto said = captureWithReplug([] {});
  ASSERT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.err, HasSubstr("US Digital QSB encoder reader, serial FT-1"));
  EXPECT_THAT(said.err, HasSubstr("the capture waits for it"));
  expectTheSweepFits();
}

TEST_F(BenchCapture, AnEncoderThatLostItsZeroIsNotGoneOnWith) {
  const auto lost = captureWithReplug([this] {
    // Without power it begins to count where it stands.
    m_shaft.zeroCounts = countsPerTurn / 2;
  });
  EXPECT_EQ(lost.code, 4);
  EXPECT_THAT(lost.err, HasSubstr("the encoder reads 0.000° and read 180.0° before it was unplugged"));
  EXPECT_THAT(lost.err, HasSubstr("begin the sweep again in a new session"));
  const auto stored = [this] {
    EXPECT_EQ(
        runCli({"export", m_folder.file("sweep.sedge"), "--format", "csv", "--out", m_folder.file("kept.csv")}).code,
        0);
    return m_folder.read("kept.csv");
  };
  const std::string kept = stored();
  EXPECT_EQ(std::count(kept.begin(), kept.end(), '\n'), 1 + points / 2) << "what was taken before, and nothing else";

  const auto again = resume();
  EXPECT_EQ(again.code, 4) << again.err;
  EXPECT_THAT(again.err, HasSubstr("the sweep's last reading was at 165.0°"));
  m_shaft.zeroCounts = -countsPerTurn / points; // turned until it shows 180°, and another zero all the same
  m_shaft.position = points / 2 - 2;
  const auto fooled = resume();
  EXPECT_EQ(fooled.code, 3) << fooled.err;
  EXPECT_THAT(fooled.err, HasSubstr("the encoder has another zero than before"));
  EXPECT_EQ(stored(), kept);

  m_shaft.zeroCounts = 0; // a reader that had kept its zero, turned back to where it was
  m_shaft.position = points / 2 - 1;
  const auto good = resume();
  EXPECT_EQ(good.code, 0) << good.err;
  expectTheSweepFits();
}

TEST_F(BenchCapture, DialoguesOfAnAngleCaptureAreRecorded) {
  m_bus.plug(encoderReader(m_shaft, -1));
  m_bus.plug(sensorBoard(m_shaft));
  const auto said =
      runCli({"capture", "angle", "--bench", benchFile("as-read"), "--session", m_folder.file("sweep.sedge"),
              "--points", std::to_string(points), "--settle", "0", "--record-dialogue", m_folder.file("said")});
  ASSERT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.err, HasSubstr("dialogues with the instruments: 2 files in " + m_folder.file("said")));
  EXPECT_EQ(m_folder.listing("said"), "ascii-board-ACM-1.dialogue usdigital-qsb-FT-1.dialogue");
  EXPECT_THAT(m_folder.read("said/usdigital-qsb-FT-1.dialogue"), HasSubstr("> R0E\\r\\n\n"));
  EXPECT_THAT(m_folder.read("said/ascii-board-ACM-1.dialogue"), HasSubstr("straightedge-dialogue 1\n"));
}

TEST_F(BenchCapture, AShaftThatTurnsIsSampledByABoardThatPrintsBothAngles) {
  // To and fro from -20° to 380°, 2,000 lines a second where the machine keeps up with them.
  auto device = std::make_shared<CdcAcmDevice>();
  device->generate([line = 0, next = std::chrono::steady_clock::now()]() mutable {
    std::string lines;
    const auto now = std::chrono::steady_clock::now();
    next = std::max(next, now - std::chrono::milliseconds(20));
    for (; next < now; next += std::chrono::microseconds(500)) {
      const double angleDeg = -20.0 + std::abs(0.125 * (line++ % 6400) - 400.0);
      std::array<char, 48> text{};
      std::snprintf(text.data(), text.size(), "%.3f\t%.4f\r\n", angleDeg, sensorDeg(angleDeg));
      lines += text.data();
    }
    return lines;
  });
  m_bus.plug(device);
  const auto bench = m_folder.write("both.json", R"({"format": "straightedge-bench", "version": 1, "name": "both",
    "instruments": [{"instrument": "ascii-board", "roles": ["angle-reference", "angle-sensor"], "serial": "ACM-1",
      "settings": {"reference_column": 1, "column": 2, "deadline_s": 60}}]})");
  const auto said = runCli({"capture", "angle", "--bench", bench, "--session", m_folder.file("sweep.sedge"), "--csv",
                            m_folder.file("sweep.csv"), "--points", std::to_string(points), "--rate", "100000"});
  ASSERT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.err,
              HasSubstr(" times a second instead of the plan's 100000: its instruments have a rate of their own"));
  const auto rates = said.err.find(" times a second");
  EXPECT_EQ(said.err.find(" times a second", rates + 1), std::string::npos) << "said once: " << said.err;
  EXPECT_THAT(said.out, HasSubstr("24 points, 2880 samples\n"));
  expectTheSweepFits(2880);
}

TEST_F(BenchCapture, AnInstrumentThatIsNotPluggedInIsNamed) {
  m_bus.plug(sensorBoard(m_shaft));
  const auto said = capture("as-read");
  EXPECT_EQ(said.code, 4);
  EXPECT_THAT(said.err, HasSubstr("US Digital QSB encoder reader, serial FT-1: the instrument is not plugged in"));
  EXPECT_EQ(m_folder.listing(), "desk.json");
}

} // namespace
} // namespace straightedge::fakes
