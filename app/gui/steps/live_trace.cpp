#include "app/gui/steps/live_trace.h"

#include "app/gui/figures/sweep_figures.h"
#include "core/angle/angles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace straightedge::gui {

namespace {

// The way the sensor counts is told from a move that is large against noise and small against a turn.
constexpr double leastMoveDeg = 2.0;
constexpr double mostMoveDeg = 90.0;

std::size_t directionIndex(const session::AngleSample& sample) { return sample.direction < 0 ? 1U : 0U; }

} // namespace

void LiveTrace::Extremes::take(double value) {
  least = filled ? std::min(least, value) : value;
  most = filled ? std::max(most, value) : value;
  filled = true;
}

void LiveTrace::clear() { *this = LiveTrace(); }

bool LiveTrace::findDirection(std::span<const session::AngleSample> all) {
  if (m_decreasing || all.empty()) {
    return false;
  }
  for (const session::AngleSample& sample : all) {
    const double encoderMove = sample.encoderDeg - all.front().encoderDeg;
    if (std::abs(encoderMove) >= leastMoveDeg && std::abs(encoderMove) <= mostMoveDeg) {
      m_decreasing = angle::wrap180(sample.sensorDeg - all.front().sensorDeg) * encoderMove < 0.0;
      return *m_decreasing; // what was drawn as increasing so far is wrong only then
    }
  }
  return false;
}

void LiveTrace::add(std::span<const session::AngleSample> all, std::size_t firstNew) {
  const bool turned = findDirection(all);
  const bool becomesDense = !m_dense && all.size() > mostPoints;
  const bool remeasured = !m_dense && std::ranges::any_of(all.subspan(firstNew), [this](const auto& sample) {
    return sample.attempt > 0 && (static_cast<std::size_t>(sample.point) >= m_attempts.size() ||
                                  m_attempts[static_cast<std::size_t>(sample.point)] < sample.attempt);
  });
  m_dense = m_dense || becomesDense;
  if (turned || becomesDense || remeasured || firstNew == 0) {
    rebuild(all);
    return;
  }
  for (const session::AngleSample& sample : all.subspan(firstNew)) {
    addOne(sample);
  }
}

void LiveTrace::rebuild(std::span<const session::AngleSample> all) {
  m_firstError.reset();
  m_attempts.clear();
  for (std::size_t direction = 0; direction < 2; ++direction) {
    m_points[direction].clear();
    m_columns[direction].assign(m_dense ? columns : 0, {});
  }
  for (const session::AngleSample& sample : all) {
    const auto point = static_cast<std::size_t>(std::max(sample.point, 0));
    if (point >= m_attempts.size()) {
      m_attempts.resize(point + 1, 0);
    }
    m_attempts[point] = std::max(m_attempts[point], sample.attempt);
  }
  for (const session::AngleSample& sample : all) {
    addOne(sample);
  }
}

std::optional<double> LiveTrace::errorDeg(const session::AngleSample& sample) const {
  if (!m_firstError) {
    return std::nullopt;
  }
  const double reading = decreasing() ? 360.0 - sample.sensorDeg : sample.sensorDeg;
  return *m_firstError + angle::wrap180(reading - sample.encoderDeg - *m_firstError);
}

void LiveTrace::addOne(const session::AngleSample& sample) {
  const auto planPoint = static_cast<std::size_t>(std::max(sample.point, 0));
  if (planPoint < m_attempts.size() && sample.attempt < m_attempts[planPoint]) {
    return; // measured again since
  }
  if (!m_firstError) {
    m_firstError = angle::wrap180((decreasing() ? 360.0 - sample.sensorDeg : sample.sensorDeg) - sample.encoderDeg);
  }
  const double error = *errorDeg(sample);
  const double encoder = angle::wrap360(sample.encoderDeg);
  if (!m_dense) {
    m_points[directionIndex(sample)].push_back({sample.point, encoder, sample.sensorDeg, error});
    return;
  }
  const auto column = std::min(static_cast<std::size_t>(encoder / 360.0 * columns), std::size_t{columns - 1});
  m_columns[directionIndex(sample)][column].sensor.take(sample.sensorDeg);
  m_columns[directionIndex(sample)][column].error.take(error);
}

PlotSeries LiveTrace::pointSeries(std::size_t direction, bool error) const {
  PlotSeries series;
  series.style = SeriesStyle::Points;
  for (const Point& point : m_points[direction]) {
    series.x.append(point.encoderDeg);
    series.y.append(error ? point.errorDeg : point.sensorDeg);
  }
  return series;
}

PlotSeries LiveTrace::columnSeries(std::size_t direction, bool error) const {
  PlotSeries series;
  series.style = SeriesStyle::Line;
  const auto& filled = m_columns[direction];
  for (std::size_t i = 0; i < filled.size(); ++i) {
    const Extremes& extremes = error ? filled[i].error : filled[i].sensor;
    const double x = (static_cast<double>(i) + 0.5) * 360.0 / columns;
    // A column in which the sensor wraps would draw a stroke over the whole height.
    const bool wraps = !error && extremes.most - extremes.least > 180.0;
    if (!extremes.filled || wraps) {
      if (!series.x.isEmpty() && !std::isnan(series.y.back())) {
        series.x.append(x);
        series.y.append(std::numeric_limits<double>::quiet_NaN());
      }
      continue;
    }
    series.x << x << x;
    series.y << extremes.least << extremes.most;
  }
  return series;
}

QList<PlotSeries> LiveTrace::series(bool error) const {
  QList<PlotSeries> list;
  for (std::size_t direction = 0; direction < 2; ++direction) {
    PlotSeries series = m_dense ? columnSeries(direction, error) : pointSeries(direction, error);
    series.name = direction == 0 ? QStringLiteral("Rising") : QStringLiteral("Falling");
    series.color = direction == 0 ? SeriesColor::First : SeriesColor::Second;
    if (series.x.isEmpty()) {
      series.name.clear(); // no legend entry for what is not there
    }
    list.append(series);
  }
  return list;
}

void LiveTrace::describe(PlotSpec& spec) const {
  if (m_dense) {
    spec.note = QStringLiteral("Smallest and largest of each of %1 columns; Review shows every reading").arg(columns);
  } else {
    spec.note =
        m_firstError ? QStringLiteral("Click a point to select it in the table") : QStringLiteral("No readings yet");
  }
}

PlotSpec LiveTrace::sensorPlot() const {
  PlotSpec spec = liveSensorFigure();
  spec.series = series(false);
  describe(spec);
  return spec;
}

PlotSpec LiveTrace::errorPlot() const {
  PlotSpec spec = liveErrorFigure();
  spec.series = series(true);
  describe(spec);
  return spec;
}

std::optional<int> LiveTrace::planPoint(int series, int index) const {
  if (m_dense || series < 0 || series > 1 || index < 0) {
    return std::nullopt;
  }
  const auto& points = m_points[static_cast<std::size_t>(series)];
  if (static_cast<std::size_t>(index) >= points.size()) {
    return std::nullopt;
  }
  return points[static_cast<std::size_t>(index)].point;
}

} // namespace straightedge::gui
