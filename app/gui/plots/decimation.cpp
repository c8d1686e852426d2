#include "app/gui/plots/decimation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace straightedge::gui {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Smallest and largest row of the pixel column that is being filled, and where the column is in data units: comparing
/// with these is quicker than finding the column of every point.
struct Column {
  double from = nan, to = nan; ///< NaN: none is being filled
  std::size_t first = 0, lowest = 0, highest = 0, last = 0;

  bool empty() const { return std::isnan(from); }
  bool contains(double x) const { return x >= from && x < to; } // false while empty
  void start(double x, const AxisScale& scale, int columns, std::size_t row) {
    const double index = std::floor(scale.toUnit(x) * columns);
    from = scale.fromUnit(index / columns);
    to = scale.fromUnit((index + 1.0) / columns);
    if (x >= to) { // rounding
      from = to;
      to = scale.fromUnit((index + 2.0) / columns);
    }
    first = lowest = highest = last = row;
  }
};

/// Liang-Barsky: the part of a–b inside the visible square and its margins, false where there is none.
bool clipSegment(UnitPoint& a, UnitPoint& b, double marginX, double marginY) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const std::array<double, 4> p = {-dx, dx, -dy, dy};
  const std::array<double, 4> q = {a.x + marginX, 1.0 + marginX - a.x, a.y + marginY, 1.0 + marginY - a.y};
  double from = 0.0;
  double to = 1.0;
  for (std::size_t side = 0; side < 4; ++side) {
    if (p[side] == 0.0) {
      if (q[side] < 0.0) {
        return false;
      }
      continue;
    }
    const double t = q[side] / p[side];
    if (p[side] < 0.0) {
      from = std::max(from, t);
    } else {
      to = std::min(to, t);
    }
    if (from > to) {
      return false;
    }
  }
  const UnitPoint start = a;
  if (to < 1.0) {
    b = {start.x + to * dx, start.y + to * dy};
  }
  if (from > 0.0) {
    a = {start.x + from * dx, start.y + from * dy};
  }
  return true;
}

bool drawable(double value, const AxisScale& scale) {
  return std::isfinite(value) && (!scale.logarithmic || value > 0.0);
}

} // namespace

std::pair<std::size_t, std::size_t> visibleRows(std::span<const double> x, double minimum, double maximum) {
  const auto lower = std::lower_bound(x.begin(), x.end(), minimum);
  const auto upper = std::upper_bound(lower, x.end(), maximum);
  auto first = static_cast<std::size_t>(lower - x.begin());
  auto last = static_cast<std::size_t>(upper - x.begin());
  first -= first > 0U ? 1U : 0U;
  last += last < x.size() ? 1U : 0U;
  return {first, last};
}

std::vector<UnitPoint> decimate(std::span<const double> x, std::span<const double> y, const AxisScale& xScale,
                                const AxisScale& yScale, int columns, bool ascending) {
  std::size_t first = 0;
  std::size_t last = std::min(x.size(), y.size());
  if (ascending && last > 0) {
    const auto rows = visibleRows(x.first(last), xScale.minimum, xScale.maximum);
    first = rows.first;
    last = rows.second;
  }
  std::vector<UnitPoint> out;
  const auto put = [&](std::size_t row) { out.push_back({xScale.toUnit(x[row]), yScale.toUnit(y[row])}); };
  const auto gap = [&out] {
    if (!out.empty() && std::isfinite(out.back().y)) {
      out.push_back({nan, nan});
    }
  };
  const bool all = last - first <= static_cast<std::size_t>(std::max(1, columns)) * 4;
  out.reserve(all ? last - first : static_cast<std::size_t>(columns) * 4 + 8);
  if (all) {
    for (std::size_t row = first; row < last; ++row) {
      if (drawable(x[row], xScale) && drawable(y[row], yScale)) {
        put(row);
      } else {
        gap();
      }
    }
    return out;
  }

  Column column;
  const auto flush = [&] {
    if (column.empty()) {
      return;
    }
    const std::size_t nearer = std::min(column.lowest, column.highest);
    const std::size_t farther = std::max(column.lowest, column.highest);
    std::size_t previous = std::numeric_limits<std::size_t>::max();
    for (const std::size_t row : {column.first, nearer, farther, column.last}) {
      if (row != previous) {
        put(row);
        previous = row;
      }
    }
    column.from = column.to = nan;
  };
  for (std::size_t row = first; row < last; ++row) {
    const double value = y[row];
    if (!drawable(value, yScale) || !drawable(x[row], xScale)) {
      flush();
      gap();
      continue;
    }
    if (!column.contains(x[row])) {
      flush();
      column.start(x[row], xScale, columns, row);
      continue;
    }
    column.last = row;
    if (value < y[column.lowest]) {
      column.lowest = row;
    } else if (value > y[column.highest]) {
      column.highest = row;
    }
  }
  flush();
  return out;
}

std::vector<UnitPoint> stepCorners(const std::vector<UnitPoint>& points) {
  std::vector<UnitPoint> out;
  out.reserve(points.size() * 2);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0 && std::isfinite(points[i].x) && std::isfinite(points[i - 1].x)) {
      out.push_back({points[i].x, points[i - 1].y});
    }
    out.push_back(points[i]);
  }
  return out;
}

std::vector<std::vector<UnitPoint>> clippedRuns(const std::vector<UnitPoint>& points, double marginX, double marginY) {
  std::vector<std::vector<UnitPoint>> runs;
  std::vector<UnitPoint> run;
  const auto close = [&] {
    if (!run.empty()) {
      runs.push_back(std::move(run));
      run = {};
    }
  };
  const auto inside = [&](const UnitPoint& p) {
    return p.x >= -marginX && p.x <= 1.0 + marginX && p.y >= -marginY && p.y <= 1.0 + marginY;
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    const UnitPoint& current = points[i];
    if (!std::isfinite(current.x) || !std::isfinite(current.y)) {
      close();
      continue;
    }
    if (i == 0 || !std::isfinite(points[i - 1].x) || !std::isfinite(points[i - 1].y)) {
      close();
      if (inside(current)) {
        run.push_back(current);
      }
      continue;
    }
    UnitPoint a = points[i - 1];
    UnitPoint b = current;
    if (!clipSegment(a, b, marginX, marginY)) {
      close();
      continue;
    }
    if (run.empty()) {
      run.push_back(a);
    }
    run.push_back(b);
    if (!inside(current)) {
      close();
    }
  }
  close();
  return runs;
}

std::vector<std::size_t> thinMarkers(std::span<const double> x, std::span<const double> y, const AxisScale& xScale,
                                     const AxisScale& yScale, int columns, int rows, bool ascending) {
  std::size_t first = 0;
  std::size_t last = std::min(x.size(), y.size());
  if (ascending && last > 0) {
    const auto visible = visibleRows(x.first(last), xScale.minimum, xScale.maximum);
    first = visible.first;
    last = visible.second;
  }
  const int w = std::max(1, columns);
  const int h = std::max(1, rows);
  std::vector<bool> taken(static_cast<std::size_t>(w) * static_cast<std::size_t>(h));
  std::vector<std::size_t> kept;
  constexpr double edge = 1e-9;
  for (std::size_t row = first; row < last; ++row) {
    const double u = xScale.toUnit(x[row]);
    const double v = yScale.toUnit(y[row]);
    if (!(u >= -edge && u <= 1.0 + edge && v >= -edge && v <= 1.0 + edge)) {
      continue;
    }
    const auto column = static_cast<std::size_t>(std::clamp(static_cast<int>(u * w), 0, w - 1));
    const auto line = static_cast<std::size_t>(std::clamp(static_cast<int>(v * h), 0, h - 1));
    const std::size_t cell = line * static_cast<std::size_t>(w) + column;
    if (!taken[cell]) {
      taken[cell] = true;
      kept.push_back(row);
    }
  }
  return kept;
}

} // namespace straightedge::gui
