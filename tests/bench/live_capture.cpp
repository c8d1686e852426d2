// What a live capture costs: frames a second of the live error plot and the processor's share, in the real window.
// live_capture [RATE_HZ] [TURNS]; by hand, in a release build, with QT_QPA_PLATFORM=offscreen or on a display.
#include "app/gui/shell/main_window.h"
#include "app/gui/shell/program_start.h"
#include "core/base/number_text.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QTemporaryDir>

#include <cstdio>
#include <ctime>

using namespace straightedge::gui;

int main(int argc, char** argv) {
  QTemporaryDir home;
  qputenv("XDG_DATA_HOME", home.path().toUtf8());
  qputenv("XDG_CONFIG_HOME", home.path().toUtf8());
  QApplication application(argc, argv);
  prepareApplication(application);
  straightedge::devices::AnglePlan plan;
  plan.sampleRateHz = argc > 1 ? straightedge::parseDouble(argv[1]).value_or(10000.0) : 10000.0;
  plan.turns = argc > 2 ? straightedge::parseInt(argv[2]).value_or(10) : 10;

  MainWindow window;
  window.resize(1280, 800);
  window.startSimulatedBench();
  window.document().setPlan(plan);
  window.show();
  auto* plot = window.findChild<PlotView*>(QStringLiteral("liveErrorPlot"));
  if (plot == nullptr ||
      !window.bench().startCapture(plan, straightedge::session::SweepRole::Calibration, false).has_value()) {
    std::fputs("the capture does not start\n", stderr);
    return 1;
  }
  int frames = 0;
  int painted = 0;
  double wallS = 0.0;
  double processorS = 0.0;
  QElapsedTimer wall;
  std::clock_t processor = 0;
  QObject::connect(plot, &PlotView::painted, &window, [&painted] { ++painted; });
  QObject::connect(&window.bench(), &BenchLink::samplesArrived, &window, [&](int) {
    if (!wall.isValid()) { // from the first samples on: the way to the start point does not count
      wall.start();
      processor = std::clock();
      painted = 0;
    }
    ++frames;
    wallS = static_cast<double>(wall.elapsed()) / 1000.0;
    processorS = static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC;
  });
  QObject::connect(&window.bench(), &BenchLink::captureEnded, &application,
                   [] { QCoreApplication::exit(0); }); // quit() would have the window ask what to do with the sweep
  QCoreApplication::exec();
  const auto samples = window.bench().liveSamples().size();
  std::printf("%zu samples in %s s: %s samples/s, %s frames/s with samples, %s plots/s, %s %% of one core, %lld lost\n",
              samples, straightedge::formatForPeople(wallS).c_str(),
              straightedge::formatForPeople(static_cast<double>(samples) / wallS).c_str(),
              straightedge::formatForPeople(frames / wallS, 3).c_str(),
              straightedge::formatForPeople(painted / wallS, 3).c_str(),
              straightedge::formatForPeople(100.0 * processorS / wallS, 3).c_str(),
              static_cast<long long>(window.bench().progress().samplesLost));
  if (const auto discarded = window.document().discard(); !discarded) {
    return 1;
  }
  return 0;
}
