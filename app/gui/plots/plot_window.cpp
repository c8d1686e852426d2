#include "app/gui/plots/plot_window.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <limits>

namespace straightedge::gui {
namespace {

constexpr double marginShare = 0.05;

struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  bool empty() const { return low > high; }
};

bool counts(double value, const PlotAxis& axis) { return std::isfinite(value) && (!axis.logarithmic || value > 0.0); }

const PlotAxis& yAxisOf(const PlotSpec& spec, const PlotSeries& series) {
  return series.rightAxis && spec.right ? *spec.right : spec.y;
}

double smallestDistance(const QList<double>& values) {
  double smallest = std::numeric_limits<double>::infinity();
  for (qsizetype i = 1; i < values.size(); ++i) {
    const double distance = std::abs(values[i] - values[i - 1]);
    if (distance > 0.0) {
      smallest = std::min(smallest, distance);
    }
  }
  return std::isfinite(smallest) ? smallest : 1.0;
}

AxisScale scaleOf(const PlotAxis& axis, Extent data, bool fromZero) {
  AxisScale scale{.minimum = 0.0, .maximum = 1.0, .logarithmic = axis.logarithmic};
  if (data.empty()) {
    data = axis.logarithmic ? Extent{1.0, 10.0} : Extent{0.0, 1.0};
  }
  if (axis.logarithmic) {
    if (data.low == data.high) {
      data = {data.low / 2.0, data.high * 2.0};
    }
    const double margin = std::pow(data.high / data.low, marginShare);
    scale.minimum = std::max(data.low / margin, 1e-300);
    scale.maximum = std::min(data.high * margin, 1e300);
  } else {
    const double size = std::max(std::abs(data.low), std::abs(data.high));
    // Equal but for rounding: widen, so that the last digit does not fill the plot.
    if (data.high - data.low <= size * 1e-14) {
      const double around = size > 0.0 ? size * 0.1 : 1.0;
      data = {data.low - around, data.high + around};
    }
    const double margin = (data.high - data.low) * marginShare;
    scale.minimum = fromZero && data.low == 0.0 ? 0.0 : data.low - margin;
    scale.maximum = fromZero && data.high == 0.0 ? 0.0 : data.high + margin;
  }
  const auto usable = [&axis](const std::optional<double>& v) { return v && counts(*v, axis); };
  if (usable(axis.minimum)) {
    scale.minimum = *axis.minimum;
  }
  if (usable(axis.maximum)) {
    scale.maximum = *axis.maximum;
  }
  if (!(scale.maximum > scale.minimum)) { // a fixed limit beyond all data
    if (usable(axis.minimum)) {
      scale.maximum = axis.logarithmic ? scale.minimum * 10.0 : scale.minimum + 1.0;
    } else {
      scale.minimum = axis.logarithmic ? scale.maximum / 10.0 : scale.maximum - 1.0;
    }
  }
  return scale;
}

} // namespace

PlotWindow PlotWindow::part(double left, double bottom, double rightEdge, double top) const {
  return {.x = x.part(left, rightEdge), .y = y.part(bottom, top), .right = right.part(bottom, top)};
}

PlotWindow wholeWindow(const PlotSpec& spec) {
  const bool someVisible =
      std::any_of(spec.series.begin(), spec.series.end(), [](const PlotSeries& s) { return s.visible; });
  Extent x;
  Extent y;
  Extent right;
  bool bars = false;
  bool rightBars = false;
  for (int index = 0; index < spec.series.size(); ++index) {
    const PlotSeries& series = spec.series[index];
    if (someVisible && !series.visible) {
      continue;
    }
    const bool onRight = series.rightAxis && spec.right;
    const PlotAxis& yAxis = yAxisOf(spec, series);
    Extent& vertical = onRight ? right : y;
    const bool isBars = series.style == SeriesStyle::Bars;
    const double halfBar = isBars ? 0.5 * smallestDistance(series.x) : 0.0;
    for (qsizetype i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
      if (counts(series.x[i], spec.x) && counts(series.y[i], yAxis)) {
        x.add(series.x[i] - (spec.x.logarithmic ? 0.0 : halfBar));
        x.add(series.x[i] + (spec.x.logarithmic ? 0.0 : halfBar));
        vertical.add(series.y[i]);
      }
    }
    if (isBars && !yAxis.logarithmic) {
      vertical.add(0.0);
      (onRight ? rightBars : bars) = true;
    }
  }
  PlotWindow window;
  window.x = scaleOf(spec.x, x, false);
  window.y = scaleOf(spec.y, y, bars);
  window.right = spec.right ? scaleOf(*spec.right, right, rightBars) : window.y;
  return window;
}

BarPlace barPlace(const PlotSpec& spec, int index) {
  int count = 0;
  int place = 0;
  double distance = std::numeric_limits<double>::infinity();
  for (int i = 0; i < spec.series.size(); ++i) {
    const PlotSeries& series = spec.series[i];
    if (series.style == SeriesStyle::Bars && (series.visible || i == index)) {
      place = i == index ? count : place;
      distance = std::min(distance, smallestDistance(series.x));
      ++count;
    }
  }
  const double width = 0.8 * (std::isfinite(distance) ? distance : 1.0) / std::max(1, count);
  return {.width = width, .offset = width * (place - 0.5 * count)};
}

QString leftOutNote(const PlotSpec& spec) {
  int left = 0;
  for (const PlotSeries& series : spec.series) {
    if (!series.visible) {
      continue;
    }
    const bool logY = yAxisOf(spec, series).logarithmic;
    if (!logY && !spec.x.logarithmic) {
      continue;
    }
    for (qsizetype i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
      left += (spec.x.logarithmic && series.x[i] <= 0.0) || (logY && series.y[i] <= 0.0) ? 1 : 0;
    }
  }
  if (left == 0) {
    return {};
  }
  return left == 1 ? QCoreApplication::translate("Plot", "1 value ≤ 0 left out of the logarithmic axis")
                   : QCoreApplication::translate("Plot", "%1 values ≤ 0 left out of the logarithmic axis").arg(left);
}

} // namespace straightedge::gui
