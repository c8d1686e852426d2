// How long a plot takes to repaint, and live data to show. Run with QT_QPA_PLATFORM=offscreen, in a release build.
#include "app/gui/plots/plot_view.h"

#include <QApplication>
#include <QImage>
#include <QPainter>
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>

namespace straightedge::gui {
namespace {

PlotSpec noisyLine(int points) {
  PlotSpec spec;
  spec.x.title = QStringLiteral("Time (s)");
  spec.y.title = QStringLiteral("Error (°)");
  PlotSeries series;
  series.name = QStringLiteral("Noise");
  series.x.reserve(points);
  series.y.reserve(points);
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0.0, 0.1);
  for (int i = 0; i < points; ++i) {
    series.x << 1e-4 * i;
    series.y << std::sin(20.0 * i / points) + noise(random);
  }
  spec.series << series;
  return spec;
}

/// A pan: everything is decimated and painted anew. 1200 × 800 logical pixels.
void repaintPanned(benchmark::State& state) {
  PlotView view;
  view.resize(1200, 800);
  view.setSpec(noisyLine(static_cast<int>(state.range(0))));
  const QRectF whole = view.visibleRange();
  QImage screen(view.size(), QImage::Format_RGB32);
  double shift = 0.0;
  for (auto _ : state) {
    shift = shift > 0.0 ? 0.0 : 1e-3 * whole.width();
    view.setVisibleRange(whole.translated(shift, 0.0));
    view.render(&screen);
  }
}
BENCHMARK(repaintPanned)->Arg(1000)->Arg(10000)->Arg(100000)->Arg(1000000)->Unit(benchmark::kMillisecond);

/// The pointer moves: the picture is there, only what lies on top is painted.
void repaintHovered(benchmark::State& state) {
  PlotView view;
  view.resize(1200, 800);
  view.setSpec(noisyLine(1000000));
  QImage screen(view.size(), QImage::Format_RGB32);
  for (auto _ : state) {
    view.render(&screen);
  }
}
BENCHMARK(repaintHovered)->Unit(benchmark::kMillisecond);

/// 10,000 samples a second, a frame every 16 ms: 160 points arrive and are shown. Range: points already there.
void liveFrame(benchmark::State& state) {
  PlotView view;
  view.resize(1200, 800);
  view.setSpec(noisyLine(static_cast<int>(state.range(0))));
  QImage screen(view.size(), QImage::Format_RGB32);
  double time = 1e-4 * static_cast<double>(state.range(0));
  for (auto _ : state) {
    QList<double> x;
    QList<double> y;
    for (int i = 0; i < 160; ++i) {
      time += 1e-4;
      x << time;
      y << std::sin(time);
    }
    view.appendPoints(0, x, y);
    view.render(&screen);
  }
}
BENCHMARK(liveFrame)->Arg(100000)->Arg(1000000)->Unit(benchmark::kMillisecond);

void paintDoubleResolution(benchmark::State& state) {
  const PlotSpec spec = noisyLine(1000000);
  QImage image(2400, 1600, QImage::Format_RGB32);
  image.setDevicePixelRatio(2.0);
  for (auto _ : state) {
    QPainter painter(&image);
    paintPlot(painter, QRectF(0, 0, 1200, 800), spec, PlotTheme::Light);
  }
}
BENCHMARK(paintDoubleResolution)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace straightedge::gui

int main(int argc, char** argv) {
  const QApplication application(argc, argv);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
