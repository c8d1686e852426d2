#include "app/gui/figures/field_verification_figures.h"

#include "app/gui/figures/field_figure_parts.h"
#include "app/gui/figures/field_words.h"
#include "app/gui/figures/figure_parts.h"

#include <algorithm>

namespace straightedge::gui {

PlotSpec fieldBeforeAfterFigure(const field::AxisErrors& errors, double fullScaleT,
                                std::optional<double> limitPercent) {
  PlotSpec spec;
  spec.title = QStringLiteral("Error before and after correction, axis %1").arg(axisLetter(errors.axis));
  spec.x = dataAxis(fieldTitle());
  spec.y = dataAxis(QStringLiteral("Error after correction (% of full scale)"));
  const double toPercent = 100.0 / fullScaleT;
  const QList<double> field = toList(errors.referenceT);
  PlotSeries before =
      pointSeries(QStringLiteral("Before"), SeriesColor::Muted, field, scaledList(errors.beforeT, toPercent));
  const PlotSeries after =
      pointSeries(QStringLiteral("After"), SeriesColor::First, field, scaledList(errors.afterT, toPercent));
  const double peakBefore = toPercent * (errors.beforeT.size() > 0 ? errors.beforeT.cwiseAbs().maxCoeff() : 0.0);
  const double peakAfter = toPercent * (errors.afterT.size() > 0 ? errors.afterT.cwiseAbs().maxCoeff() : 0.0);
  const double needed = std::max(peakAfter, limitPercent.value_or(0.0));
  constexpr double sharedAxis = 5.0;
  if (peakBefore > sharedAxis * needed && needed > 0.0) {
    before.rightAxis = true;
    before.name = QStringLiteral("Before (right axis)");
    // both scales symmetric: zero is at the same height on the left and on the right
    constexpr double room = 1.15;
    spec.right = dataAxis(QStringLiteral("Error before correction (% of full scale)"));
    spec.right->minimum = -room * peakBefore;
    spec.right->maximum = room * peakBefore;
    spec.y.minimum = -room * needed;
    spec.y.maximum = room * needed;
  } else {
    spec.y.title = QStringLiteral("Error (% of full scale)");
  }
  spec.series = {before, after};
  if (limitPercent) {
    for (const double value : {*limitPercent, -*limitPercent}) {
      PlotGuide guide;
      guide.id = value > 0.0 ? QStringLiteral("limit") : QStringLiteral("lower limit");
      guide.label = value > 0.0 ? QStringLiteral("Limit") : QString();
      guide.value = value;
      guide.color = SeriesColor::Bad;
      guide.unit = QStringLiteral(" %");
      spec.guides.append(guide);
    }
  }
  spec.note = QStringLiteral("Largest error %1 before, %2 after, over %3 readings")
                  .arg(percentText(peakBefore), percentText(peakAfter))
                  .arg(errors.afterT.size());
  return spec;
}

PlotSpec blockPeaksFigure(const std::vector<field::VerificationRow>& rows) {
  PlotSpec spec;
  spec.title = QStringLiteral("Largest error before and after each block");
  spec.y = dataAxis(QStringLiteral("Peak error (% of full scale)"));
  spec.y.logarithmic = true;
  std::vector<field::VerifiedState> states;
  for (const field::VerificationRow& row : rows) {
    if (std::ranges::find(states, row.state) == states.end()) {
      states.push_back(row.state);
    }
  }
  std::ranges::sort(states);
  using enum field::VerifiedState;
  if (std::ranges::any_of(states,
                          [](field::VerifiedState state) { return state > Uncalibrated && state < Calibrated; })) {
    std::erase(states, Calibrated); // the same as after the last block
  }
  QStringList key;
  for (std::size_t i = 0; i < states.size(); ++i) {
    key << QStringLiteral("%1 %2").arg(i).arg(stateTitle(states[i]));
  }
  spec.x = dataAxis(QStringLiteral("Blocks applied"));
  spec.x.minimum = -0.5;
  spec.x.maximum = static_cast<double>(states.size()) - 0.5;
  spec.x.tickStep = 1.0;
  for (const field::Axis axis : field::allAxes) {
    PlotSeries series = lineSeries(QStringLiteral("Axis %1").arg(axisLetter(axis)), axisColor(axis));
    series.style = SeriesStyle::LineAndPoints;
    for (std::size_t i = 0; i < states.size(); ++i) {
      const auto row = std::ranges::find_if(
          rows, [&](const field::VerificationRow& each) { return each.axis == axis && each.state == states[i]; });
      if (row != rows.end()) {
        series.x.append(static_cast<double>(i));
        series.y.append(row->ofFullScale.peak);
        series.pointLabels.append(stateTitle(states[i]));
      }
    }
    if (!series.x.isEmpty()) {
      spec.series.append(series);
    }
  }
  spec.note = key.join(QStringLiteral(", "));
  return spec;
}

} // namespace straightedge::gui
