#include "app/gui/figures/field_surface_figures.h"

#include "app/gui/figures/field_figure_parts.h"
#include "core/field/step_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace straightedge::gui {

namespace {

/// Means of runs of values that lie within `tolerance` of their neighbours, ascending.
std::vector<double> settingsOf(const Eigen::VectorXd& values, double tolerance) {
  std::vector<double> sorted(values.begin(), values.end());
  std::ranges::sort(sorted);
  std::vector<double> settings;
  for (std::size_t first = 0; first < sorted.size();) {
    std::size_t last = first + 1;
    double sum = sorted[first];
    while (last < sorted.size() && sorted[last] - sorted[last - 1] <= tolerance) {
      sum += sorted[last++];
    }
    settings.push_back(sum / static_cast<double>(last - first));
    first = last;
  }
  return settings;
}

std::size_t nearest(const std::vector<double>& settings, double value) {
  const auto above = std::ranges::lower_bound(settings, value);
  if (above == settings.begin()) {
    return 0;
  }
  const bool below = above == settings.end() || value - *std::prev(above) <= *above - value;
  return static_cast<std::size_t>(above - settings.begin()) - (below ? 1 : 0);
}

/// The temperatures that were held; of a temperature that was swept, the middles of equal bands.
std::vector<double> temperaturesOf(const Eigen::VectorXd& probeC, double coldest, double span) {
  constexpr double share = 0.05; // of the span: wider gaps part one temperature from the next
  std::vector<double> held = settingsOf(probeC, share * span);
  if (held.size() >= 2) {
    return held;
  }
  constexpr int bands = 8;
  std::vector<double> middles;
  for (int band = 0; band < bands; ++band) {
    middles.push_back(coldest + span * (band + 0.5) / bands);
  }
  return middles;
}

/// Cells of fields and temperatures that readings fall into; empty where there are fewer than two of either.
struct SurfaceGrid {
  std::vector<double> fieldsT, probeC;
  std::vector<std::size_t> cellOfReading;

  bool isEmpty() const { return cellOfReading.empty(); }
};

SurfaceGrid gridOf(const field::AxisErrors& errors) {
  SurfaceGrid grid;
  if (errors.probeC.size() == 0) {
    return grid;
  }
  grid.fieldsT = settingsOf(errors.referenceT, field::plateauToleranceT);
  const double coldest = errors.probeC.minCoeff();
  const double span = errors.probeC.maxCoeff() - coldest;
  if (grid.fieldsT.size() < 2 || !(span > 0.0)) {
    return grid;
  }
  grid.probeC = temperaturesOf(errors.probeC, coldest, span);
  for (Eigen::Index i = 0; i < errors.probeC.size(); ++i) {
    grid.cellOfReading.push_back(nearest(grid.probeC, errors.probeC[i]) * grid.fieldsT.size() +
                                 nearest(grid.fieldsT, errors.referenceT[i]));
  }
  return grid;
}

/// Means of the cells in percent of full scale, row by row of equal temperature.
QList<double> heightsOn(const SurfaceGrid& grid, const Eigen::VectorXd& errorT, double fullScaleT) {
  const std::size_t cells = grid.fieldsT.size() * grid.probeC.size();
  std::vector<double> sum(cells, 0.0);
  std::vector<int> count(cells, 0);
  for (Eigen::Index i = 0; i < errorT.size(); ++i) {
    const std::size_t cell = grid.cellOfReading[static_cast<std::size_t>(i)];
    sum[cell] += 100.0 * errorT[i] / fullScaleT;
    ++count[cell];
  }
  QList<double> heights;
  for (std::size_t cell = 0; cell < cells; ++cell) {
    heights.append(count[cell] > 0 ? sum[cell] / count[cell] : std::numeric_limits<double>::quiet_NaN());
  }
  return heights;
}

/// Equally far below zero as above, so that blue and red weigh the same.
std::pair<double, double> evenRange(std::initializer_list<const QList<double>*> lists) {
  double reach = 0.0;
  for (const QList<double>* heights : lists) {
    for (const double height : *heights) {
      reach = std::isfinite(height) ? std::max(reach, std::abs(height)) : reach;
    }
  }
  return {-reach, reach};
}

} // namespace

SurfaceSpec residualSurface(const field::AxisErrors& errors, double fullScaleT, double referenceTemperatureC,
                            CorrectionState state, SurfaceScale scale) {
  SurfaceSpec spec;
  const bool before = state == CorrectionState::Before;
  spec.title = QStringLiteral("Error over field and temperature %1 correction, axis %2")
                   .arg(before ? QStringLiteral("before") : QStringLiteral("after"), axisLetter(errors.axis));
  spec.xTitle = fieldTitle();
  spec.yTitle = probeTitle();
  spec.zTitle = QStringLiteral("Error (% of full scale)");
  spec.colors = SurfaceColors::DivergingFromZero;
  const SurfaceGrid grid = gridOf(errors);
  if (grid.isEmpty()) {
    return spec;
  }
  spec.x = QList<double>(grid.fieldsT.begin(), grid.fieldsT.end());
  for (const double aboveReference : grid.probeC) {
    spec.y.append(referenceTemperatureC + aboveReference);
  }
  spec.z = heightsOn(grid, before ? errors.beforeT : errors.afterT, fullScaleT);
  if (scale == SurfaceScale::Own) {
    spec.zRange = evenRange({&spec.z});
  } else {
    const QList<double> other = heightsOn(grid, before ? errors.afterT : errors.beforeT, fullScaleT);
    spec.zRange = evenRange({&spec.z, &other});
  }
  return spec;
}

} // namespace straightedge::gui
