#include "tests/app/gui/plots/figures.h"

#include <cmath>
#include <numbers>

namespace straightedge::gui::figures {
namespace {

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

double correction(double degrees) {
  return 3.1 * std::sin(radians(degrees) + 0.4) + 1.7 * std::sin(2.0 * radians(degrees) - 1.0) +
         0.35 * std::sin(4.0 * radians(degrees));
}

PlotAxis angleAxis() {
  PlotAxis axis;
  axis.title = QStringLiteral("Sensor angle (°)");
  axis.minimum = 0.0;
  axis.maximum = 360.0;
  axis.tickStep = 45.0;
  return axis;
}

PlotSeries series(const QString& name, SeriesStyle style, SeriesColor color) {
  PlotSeries result;
  result.name = name;
  result.style = style;
  result.color = color;
  return result;
}

} // namespace

PlotSpec errorOverAngle() {
  PlotSpec spec;
  spec.title = QStringLiteral("Correction curve");
  spec.x = angleAxis();
  spec.y.title = QStringLiteral("Correction (°)");
  PlotSeries curve = series(QStringLiteral("Curve (spline)"), SeriesStyle::Line, SeriesColor::Reference);
  for (int i = 0; i <= 720; ++i) {
    curve.x << 0.5 * i;
    curve.y << correction(0.5 * i);
  }
  PlotSeries harmonic = series(QStringLiteral("harmonic:4"), SeriesStyle::Line, SeriesColor::First);
  harmonic.dashed = true;
  for (int i = 0; i <= 360; ++i) {
    harmonic.x << i;
    harmonic.y << correction(i) + 0.25 * std::sin(radians(7.0 * i));
  }
  PlotSeries points = series(QStringLiteral("Measured points"), SeriesStyle::Points, SeriesColor::Second);
  for (int i = 0; i < 32; ++i) {
    points.x << 11.25 * i;
    points.y << correction(11.25 * i);
    points.emphasised << (i == 7 || i == 20);
  }
  spec.series << curve << harmonic << points;
  spec.guides << PlotGuide{QStringLiteral("limit"), QStringLiteral("Limit"), false, 4.0, false,
                           SeriesColor::Bad,        QStringLiteral("°")};
  spec.note = QStringLiteral("Two points are switched off.");
  return spec;
}

PlotSpec errorVersusStorage() {
  PlotSpec spec;
  spec.title = QStringLiteral("Residual error versus storage");
  spec.x.title = QStringLiteral("Storage (entries)");
  spec.x.logarithmic = true;
  spec.y.title = QStringLiteral("Maximum error (°)");
  spec.y.logarithmic = true;
  const QStringList names = {QStringLiteral("Harmonics"), QStringLiteral("Linear, least squares"),
                             QStringLiteral("Linear, on curve"), QStringLiteral("Table, mean"),
                             QStringLiteral("Table, mid-range")};
  const QList<double> order = {3.0, 2.0, 2.0, 1.0, 1.0};
  const QList<double> level = {60.0, 25.0, 45.0, 12.0, 9.0};
  for (int s = 0; s < 5; ++s) {
    PlotSeries one = series(names[s], SeriesStyle::LineAndPoints, static_cast<SeriesColor>(s + 1));
    for (int n = 2; n <= 1024; ++n) {
      const double wobble = 1.0 + 0.12 * std::sin(1.7 * n + s) + 0.05 * std::sin(0.31 * n);
      one.x << n;
      one.y << level[s] * wobble / std::pow(n, order[s]) + 1e-7;
      one.pointLabels << QStringLiteral("size %1").arg(n);
    }
    spec.series << one;
  }
  spec.series[1].emphasised = QList<bool>(1023, false);
  spec.series[1].emphasised[30] = true;
  spec.series[0].y[500] = 0.0;
  spec.guides << PlotGuide{QStringLiteral("target"), QStringLiteral("Target"), false, 0.05, true,
                           SeriesColor::Good,        QStringLiteral("°")}
              << PlotGuide{QStringLiteral("budget"), QStringLiteral("Budget"), true, 64.0, true,
                           SeriesColor::Bad,         QStringLiteral("entries")};
  return spec;
}

PlotSpec harmonics() {
  PlotSpec spec;
  spec.title = QStringLiteral("Harmonics of the correction");
  spec.x.title = QStringLiteral("Harmonic");
  spec.x.tickStep = 1.0;
  spec.y.title = QStringLiteral("Amplitude (°)");
  PlotSeries bars = series(QString(), SeriesStyle::Bars, SeriesColor::First);
  for (int k = 1; k <= 16; ++k) {
    bars.x << k;
    bars.y << 3.2 / std::pow(k, 1.4) * (1.0 + 0.5 * std::cos(2.0 * k));
    bars.emphasised << (k <= 4);
  }
  spec.series << bars;
  return spec;
}

PlotSpec residualSteps() {
  PlotSpec spec;
  spec.title = QStringLiteral("Residual of lut:32 and linear:32");
  spec.x = angleAxis();
  spec.y.title = QStringLiteral("Residual error (°)");
  PlotSeries table = series(QStringLiteral("lut:32, stored values"), SeriesStyle::Steps, SeriesColor::First);
  for (int k = 0; k <= 32; ++k) {
    table.x << 11.25 * k;
    table.y << 0.1 * correction(11.25 * (k % 32) + 5.625);
  }
  PlotSeries curve = series(QStringLiteral("curve / 10"), SeriesStyle::Line, SeriesColor::Reference);
  PlotSeries residual = series(QStringLiteral("linear:32"), SeriesStyle::Line, SeriesColor::Second);
  for (int i = 0; i <= 4096; ++i) {
    const double angle = 360.0 * i / 4096.0;
    const double part = std::fmod(angle, 11.25) / 11.25;
    curve.x << angle;
    curve.y << 0.1 * correction(angle);
    residual.x << angle;
    residual.y << 0.09 * (part * (1.0 - part) - 0.1667) * std::sin(2.0 * radians(angle) - 0.4) * 8.0;
  }
  spec.series << curve << table << residual;
  return spec;
}

PlotSpec coverageRing() {
  PlotSpec spec;
  spec.polar = true;
  spec.title = QStringLiteral("Coverage");
  spec.y.minimum = 0.0;
  spec.y.maximum = 1.0;
  PlotSeries planned = series(QStringLiteral("Planned"), SeriesStyle::Points, SeriesColor::Muted);
  PlotSeries measured = series(QStringLiteral("Measured"), SeriesStyle::Points, SeriesColor::Good);
  PlotSeries now = series(QStringLiteral("Shaft"), SeriesStyle::Bars, SeriesColor::Second);
  for (int i = 0; i < 64; ++i) {
    (i < 45 ? measured : planned).x << 5.625 * i;
    (i < 45 ? measured : planned).y << 0.92;
    if (i >= 45) {
      planned.emphasised << true;
    }
  }
  now.x << 253.1;
  now.y << 0.92;
  spec.series << planned << measured << now;
  spec.note = QStringLiteral("45 of 64 points, gap of 101° from 253° to 354°");
  return spec;
}

PlotSpec secondAxis() {
  PlotSpec spec;
  spec.title = QStringLiteral("Drift while warming up");
  spec.x.title = QStringLiteral("Time (s)");
  spec.y.title = QStringLiteral("Error (m°)");
  spec.right = PlotAxis{};
  spec.right->title = QStringLiteral("Temperature (°C)");
  PlotSeries error = series(QStringLiteral("Error"), SeriesStyle::Line, SeriesColor::First);
  PlotSeries temperature = series(QStringLiteral("Temperature"), SeriesStyle::Line, SeriesColor::Second);
  temperature.rightAxis = true;
  temperature.dashed = true;
  for (int i = 0; i <= 900; ++i) {
    const double t = 2.0 * i;
    error.x << t;
    error.y << (i > 400 && i < 430 ? std::nan("") : 14.0 * (1.0 - std::exp(-t / 500.0)) + std::sin(0.37 * i) * 0.8);
    temperature.x << t;
    temperature.y << 23.0 + 11.5 * (1.0 - std::exp(-t / 600.0));
  }
  spec.series << error << temperature;
  return spec;
}

PlotSpec tinyRange() {
  PlotSpec spec;
  spec.title = QStringLiteral("Resistance of the 100 Ω reference, ratio θ");
  spec.x.title = QStringLiteral("Time (s since 1970)");
  spec.y.title = QStringLiteral("Ratio");
  PlotSeries ratio = series(QStringLiteral("Ratio R/R₀"), SeriesStyle::Line, SeriesColor::Third);
  for (int i = 0; i <= 600; ++i) {
    ratio.x << 1.7e9 + i;
    ratio.y << 1.0 + 1e-9 * std::sin(0.03 * i);
  }
  spec.series << ratio;
  return spec;
}

} // namespace straightedge::gui::figures
