// A board that streams both angles over USB, all the way into the window: emulated device, the real libusb, transport,
// parser, capture thread, session on disk, and the Capture step of the real window. Counts what was sent and stored,
// frames a second, and the processor's share of every part.
// usb_stream [SECONDS [RATE_HZ]]; with LD_PRELOAD=libumockdev-preload.so.0 and QT_QPA_PLATFORM=offscreen.
#include "app/gui/shell/main_window.h"
#include "app/gui/shell/program_start.h"
#include "core/base/number_text.h"
#include "devices/bench/opened_bench.h"
#include "tests/bench/thread_times.h"
#include "tests/fakes/usb/byte_stream_devices.h"
#include "tests/fakes/usb/emulated_usb.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QTemporaryDir>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <numeric>

using namespace straightedge;
using namespace straightedge::gui;
using devices::InstrumentRole;

namespace {

/// Somebody turns it at one turn a second once the capture asks for it; the board samples it at a fixed rate.
struct TurnedShaft {
  double rateHz = 10000.0;
  int turns = 60;
  std::atomic<bool> turning = false;
  std::atomic<std::int64_t> sent = 0; ///< lines of the sweep itself
  std::int64_t steps = 0;             ///< since it began to turn, from -5°; the board's thread only

  double next() {
    const double angleDeg = -5.0 + 360.0 / rateHz * static_cast<double>(turning ? steps++ : 0);
    sent += angleDeg >= 0.0 && angleDeg < 360.0 * turns ? 1 : 0;
    return angleDeg;
  }
};

std::string lineOf(double encoderDeg) {
  const double shifted = encoderDeg + 3.0 * std::sin(encoderDeg * 0.017453292519943295) + 20.0;
  std::array<char, 48> text{};
  const int size = std::snprintf(text.data(), text.size(), "%.4f,%.4f\r\n", encoderDeg,
                                 shifted - 360.0 * std::floor(shifted / 360.0));
  return {text.data(), static_cast<std::size_t>(size)};
}

std::shared_ptr<fakes::CdcAcmDevice> boardOn(TurnedShaft& shaft) {
  auto board = std::make_shared<fakes::CdcAcmDevice>();
  board->generate([&shaft, began = std::chrono::steady_clock::now(), printed = std::int64_t{0},
                   frame = std::int64_t{-1}]() mutable {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - began;
    const auto nowFrame = static_cast<std::int64_t>(passed.count() * 1000.0);
    if (nowFrame == frame) {
      return std::string(); // a full-speed device is asked once in a frame of 1 ms
    }
    frame = nowFrame;
    const auto due = static_cast<std::int64_t>(passed.count() * shaft.rateHz);
    if (!shaft.turning) { // while nobody listens its buffer is full; in the sweep nothing may be left out
      printed = std::max(printed, due - 100);
    }
    std::string lines;
    for (; printed < due; ++printed) {
      lines += lineOf(shaft.next());
    }
    return lines;
  });
  return board;
}

const devices::SavedBench oneBoard = {
    .name = "emulated board",
    .instruments = {{.instrument = "ascii-board",
                     .roles = {InstrumentRole::AngleSensor, InstrumentRole::AngleReference},
                     .serial = "ACM-1",
                     .port = {},
                     .settings = {{"reference_column", "1"}, {"column", "2"}},
                     .baud = {}}}};

/// Processor shares between two moments.
class Shares {
public:
  void begin() {
    m_wall.start();
    m_before = bench::threadTimes();
  }
  void end() {
    m_after = bench::threadTimes();
    m_wallS = static_cast<double>(m_wall.elapsed()) / 1000.0;
  }
  double wallS() const { return m_wallS; }
  std::map<std::string, double> percent() const {
    std::map<std::string, double> shares;
    for (const auto& [name, seconds] : m_after) {
      const auto before = m_before.find(name);
      shares[name] = 100.0 * (seconds - (before == m_before.end() ? 0.0 : before->second)) / m_wallS;
    }
    return shares;
  }

private:
  QElapsedTimer m_wall;
  double m_wallS = 0.0;
  std::map<std::string, double> m_before;
  std::map<std::string, double> m_after;
};

/// What the threads are for; the others belong to the emulated bus.
const std::map<std::string, const char*> parts = {{"main", "window"},
                                                  {"capture", "capture: libusb, transport, parser, sink"},
                                                  {"session", "session's own commits"},
                                                  {"libusb_event", "libusb's event thread"},
                                                  {"Thread", "window: jobs"}};

void printShares(const Shares& shares) {
  double program = 0.0;
  double emulation = 0.0;
  for (const auto& [name, percent] : shares.percent()) {
    const auto part = parts.find(name);
    (part == parts.end() ? emulation : program) += percent;
    if (percent >= 0.05) {
      std::printf("  %5.1f %%  %-14s %s\n", percent, name.c_str(),
                  part == parts.end() ? "emulated bus and device" : part->second);
    }
  }
  std::printf("  %5.1f %% of one core for the program (goal 60), %.1f %% for the emulation beside it\n", program,
              emulation);
}

} // namespace

int main(int argc, char** argv) {
  const QTemporaryDir home;
  qputenv("XDG_DATA_HOME", home.path().toUtf8());
  qputenv("XDG_CONFIG_HOME", home.path().toUtf8());
  TurnedShaft shaft;
  shaft.turns = argc > 1 ? parseInt(argv[1]).value_or(60) : 60; // one a second
  shaft.rateHz = argc > 2 ? parseDouble(argv[2]).value_or(10000.0) : 10000.0;
  fakes::EmulatedUsb bus;
  bus.plug(boardOn(shaft));

  QApplication application(argc, argv);
  prepareApplication(application);
  auto opened = devices::OpenedBench::open(oneBoard, {});
  if (!opened) {
    std::fprintf(stderr, "%s\n", opened.error().message().c_str());
    return 1;
  }
  const std::shared_ptr<devices::OpenedBench> bench = *std::move(opened);

  devices::AnglePlan plan;
  plan.sampleRateHz = shaft.rateHz;
  plan.turns = shaft.turns;
  MainWindow window;
  window.resize(1280, 800);
  window.startSimulatedBench(); // and on its Capture step the other bench
  BenchLink& link = window.bench();
  if (!link.connectBench(*bench->angleBench(), bench)) {
    return 1;
  }
  window.document().setPlan(plan);
  window.show();
  auto* plot = window.findChild<PlotView*>(QStringLiteral("liveErrorPlot"));
  if (plot == nullptr || !link.startCapture(plan, session::SweepRole::Calibration, false)) {
    std::fputs("the capture does not start\n", stderr);
    return 1;
  }

  Shares shares;
  int frames = 0;
  int painted = 0;
  int framesInAll = 0;
  int paintedInAll = 0;
  devices::CaptureProgress last;
  QObject::connect(plot, &PlotView::painted, &window, [&painted] { ++painted; });
  QObject::connect(&link, &BenchLink::progressChanged, &window, [&] {
    last = link.isCapturing() ? link.progress() : last;
    if (!shaft.turning && link.progress().note.starts_with("turn the shaft")) {
      shaft.turning = true;
    }
  });
  QObject::connect(&link, &BenchLink::samplesArrived, &window, [&](int) {
    const auto samples = static_cast<double>(link.liveSamples().size());
    if (frames++ == 0) {
      shares.begin();
      painted = 0;
    } else if (framesInAll == 0 && samples >= 0.995 * shaft.rateHz * shaft.turns) { // before the threads end
      shares.end();
      framesInAll = frames;
      paintedInAll = painted;
    }
  });
  QObject::connect(&link, &BenchLink::captureEnded, &application,
                   [] { QCoreApplication::exit(0); }); // quit() would have the window ask what to do with the sweep
  QCoreApplication::exec();

  const session::Session* session = window.document().session();
  const auto stored = session->angleSampleCount(session::SweepRole::Calibration).value_or(-1);
  const auto gaps = session->gaps(session::SweepRole::Calibration).value_or(std::vector<session::SampleGap>{});
  const auto missing = std::accumulate(gaps.begin(), gaps.end(), std::int64_t{0},
                                       [](std::int64_t sum, const auto& gap) { return sum + gap.count; });
  std::printf("%lld samples sent in the sweep, %lld stored, %lld lost, %lld recorded as gaps, %lld not drawn\n",
              static_cast<long long>(shaft.sent), static_cast<long long>(stored),
              static_cast<long long>(shaft.sent - stored), static_cast<long long>(missing),
              static_cast<long long>(link.progress().samplesLost));
  std::printf("in %.1f s: %.0f samples/s, %.1f frames/s with samples, %.1f plots/s (goal 60)\n", shares.wallS(),
              static_cast<double>(stored) / shares.wallS(), framesInAll / shares.wallS(),
              paintedInAll / shares.wallS());
  if (!last.note.empty()) {
    std::printf("the program says: %s\n", last.note.c_str());
  }
  printShares(shares);
  const bool whole = stored == shaft.sent && missing == 0;
  link.disconnectBench();
  const auto discarded = window.document().discard();
  return whole && discarded ? 0 : 1;
}
