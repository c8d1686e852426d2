#include "app/gui/figures/field_cost_figures.h"

#include "app/gui/figures/field_figure_parts.h"
#include "app/gui/figures/figure_parts.h"
#include "core/field/names.h"

#include <algorithm>
#include <map>

namespace straightedge::gui {

PlotSpec expandedUncertaintyFigure(const field::UncertaintySummary& summary) {
  PlotSpec spec;
  spec.title = QStringLiteral("Expanded uncertainty of a corrected reading");
  spec.x = dataAxis(QStringLiteral("Field along the axis (T)"));
  spec.y = dataAxis(QStringLiteral("Expanded uncertainty, 95 % (µT)"));
  spec.y.minimum = 0.0;
  if (summary.grid.empty()) {
    spec.note = QStringLiteral("The calibration states no uncertainty over field and temperature");
    return spec;
  }
  // The grid begins at the reference temperatures.
  const double probeC = summary.grid.front().probeC;
  const double electronicsC = summary.grid.front().electronicsC;
  for (const field::Axis axis : field::allAxes) {
    std::map<double, double> here;
    std::map<double, double> worst;
    for (const field::UncertaintyAt& at : summary.grid) {
      if (at.axis != static_cast<int>(field::indexOf(axis))) {
        continue;
      }
      double& largest = worst[at.fieldT];
      largest = std::max(largest, at.expandedT / teslaPerMicrotesla);
      if (at.probeC == probeC && at.electronicsC == electronicsC) {
        here[at.fieldT] = at.expandedT / teslaPerMicrotesla;
      }
    }
    if (here.empty()) {
      continue;
    }
    PlotSeries series = lineSeries(QStringLiteral("Axis %1").arg(axisLetter(axis)), axisColor(axis));
    PlotSeries any = lineSeries(QStringLiteral("%1, any temperature").arg(axisLetter(axis)), axisColor(axis));
    any.dashed = true;
    for (const auto& [fieldT, value] : here) {
      series.x.append(fieldT);
      series.y.append(value);
    }
    for (const auto& [fieldT, value] : worst) {
      any.x.append(fieldT);
      any.y.append(value);
    }
    spec.series << series << any;
  }
  spec.note = QStringLiteral("Solid at %1 °C probe and %2 °C electronics; largest %3, median %4")
                  .arg(peopleNumber(probeC), peopleNumber(electronicsC), microteslaText(summary.largestT),
                       microteslaText(summary.medianT));
  return spec;
}

namespace {

QString familyTitle(int slopeOrder, bool blockLeftOut) {
  return blockLeftOut ? QStringLiteral("A block left out") : QStringLiteral("Slope of order %1").arg(slopeOrder);
}

} // namespace

StorageFigure storageFigure(const field::StorageComparison& comparison, ChainCost cost, int order, int slopeOrder) {
  StorageFigure figure;
  PlotSpec& spec = figure.spec;
  const bool coefficients = cost == ChainCost::Coefficients;
  spec.title = QStringLiteral("Storage against error");
  spec.x = dataAxis(coefficients ? QStringLiteral("Coefficients of all axes")
                                 : QStringLiteral("Multiplications for one reading"));
  spec.y = dataAxis(QStringLiteral("Peak error that remains (% of full scale)"));
  spec.y.logarithmic = true;
  const auto costOf = [coefficients](const field::StorageChoice& choice) {
    return static_cast<double>(coefficients ? choice.size.coefficients : choice.size.multiplications);
  };
  std::map<int, int> placeOfFamily; // slope order, 4 for a block left out -> series
  constexpr int leftOut = 4;
  for (std::size_t i = 0; i < comparison.choices.size(); ++i) {
    const field::StorageChoice& choice = comparison.choices[i];
    const int family = choice.without ? leftOut : choice.slopeOrder;
    const auto [found, isNew] = placeOfFamily.try_emplace(family, static_cast<int>(spec.series.size()));
    if (isNew) {
      PlotSeries series = lineSeries(familyTitle(choice.slopeOrder, choice.without.has_value()),
                                     choice.without ? SeriesColor::Muted : seriesColor(choice.slopeOrder));
      series.style = choice.without ? SeriesStyle::Points : SeriesStyle::LineAndPoints;
      spec.series.append(series);
      figure.choices.emplace_back();
    }
    PlotSeries& series = spec.series[found->second];
    series.x.append(costOf(choice));
    series.y.append(choice.largestPeakPercent);
    series.pointLabels.append(fromText(choice.name));
    series.emphasised.append(!choice.without && choice.order == order && choice.slopeOrder == slopeOrder);
    figure.choices[static_cast<std::size_t>(found->second)].push_back(i);
  }
  spec.note = QStringLiteral("Every choice fitted anew, its blocks together; measured over the %1")
                  .arg(fromText(comparison.measuredWith));
  return figure;
}

} // namespace straightedge::gui
