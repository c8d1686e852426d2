#include "app/gui/figures/figure_parts.h"
#include "app/gui/figures/sweep_figures.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace straightedge::gui {

namespace {

/// Encoder readings of one station differ by the encoder's own noise; stations are at least this far apart.
constexpr double sameStationDeg = 0.02;

/// Readings minus the mean of their group (same station, turn and direction), degrees.
std::vector<double> deviationsWithinGroups(const angle::AlignedSweep& aligned) {
  const auto count = static_cast<std::size_t>(aligned.encoderDeg.size());
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto turnOf = [&](std::size_t i) { return i < aligned.turn.size() ? aligned.turn[i] : 0; };
  const auto passOf = [&](std::size_t i) { return i < aligned.pass.size() ? aligned.pass[i] : 1; };
  const auto encoderOf = [&](std::size_t i) { return aligned.encoderDeg[static_cast<Eigen::Index>(i)]; };
  const auto correctionOf = [&](std::size_t i) { return aligned.correctionDeg[static_cast<Eigen::Index>(i)]; };
  std::ranges::sort(order, {}, [&](std::size_t i) { return std::tuple(turnOf(i), passOf(i), encoderOf(i)); });
  std::vector<double> deviations;
  for (std::size_t first = 0; first < count;) {
    std::size_t last = first + 1;
    double sum = correctionOf(order[first]);
    while (last < count && turnOf(order[last]) == turnOf(order[first]) && passOf(order[last]) == passOf(order[first]) &&
           encoderOf(order[last]) - encoderOf(order[last - 1]) < sameStationDeg) {
      sum += correctionOf(order[last++]);
    }
    if (last - first > 1) {
      const double mean = sum / static_cast<double>(last - first);
      for (std::size_t i = first; i < last; ++i) {
        deviations.push_back(mean - correctionOf(order[i])); // a reading that is too high needs a smaller correction
      }
    }
    first = last;
  }
  return deviations;
}

double sigmaOf(const std::vector<double>& values) {
  double squares = 0.0;
  for (const double value : values) {
    squares += value * value;
  }
  return values.empty() ? 0.0 : std::sqrt(squares / static_cast<double>(values.size()));
}

} // namespace

PlotSpec noiseHistogramFigure(const angle::AlignedSweep& aligned, const angle::CorrectionCurve* curve) {
  PlotSpec spec = emptyFigure(QStringLiteral("Noise"), dataAxis(QStringLiteral("Deviation of a reading (°)")),
                              dataAxis(QStringLiteral("Readings")), {});
  std::vector<double> deviations = deviationsWithinGroups(aligned);
  QString from = QStringLiteral("about the mean at each angle");
  if (deviations.empty() && curve != nullptr && curve->method == angle::CurveMethod::Regress) {
    for (Eigen::Index i = 0; i < aligned.readingDeg.size(); ++i) {
      deviations.push_back(curve->at(aligned.readingDeg[i]) - aligned.correctionDeg[i]);
    }
    from = QStringLiteral("about the regressed curve");
  }
  const double largest =
      deviations.empty() ? 0.0
                         : std::abs(*std::ranges::max_element(deviations, {}, [](double v) { return std::abs(v); }));
  if (largest <= 0.0) {
    spec.note = deviations.empty() ? QStringLiteral("Each angle was read once: noise needs averages or several turns.")
                                   : QStringLiteral("All readings of an angle are equal.");
    return spec;
  }
  // as many bins as the square root rule gives, odd so that zero lies in the middle of one
  const int bins = std::clamp(static_cast<int>(std::sqrt(static_cast<double>(deviations.size()))) | 1, 7, 61);
  const double width = 2.0 * largest / bins;
  PlotSeries bars;
  bars.name = QStringLiteral("Readings");
  bars.style = SeriesStyle::Bars;
  for (int k = 0; k < bins; ++k) {
    bars.x.append(-largest + (k + 0.5) * width);
    bars.y.append(0.0);
  }
  for (const double value : deviations) {
    const int bin = std::clamp(static_cast<int>((value + largest) / width), 0, bins - 1);
    bars.y[bin] += 1.0;
  }
  spec.y.minimum = 0.0;
  spec.series.append(bars);
  spec.note = QStringLiteral("%1 readings %2; root mean square %3")
                  .arg(deviations.size())
                  .arg(from, degrees(sigmaOf(deviations), 3));
  return spec;
}

} // namespace straightedge::gui
