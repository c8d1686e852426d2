#include "app/gui/figures/field_campaign_figures.h"

#include "app/gui/figures/field_figure_parts.h"
#include "app/gui/figures/field_words.h"
#include "app/gui/figures/figure_parts.h"
#include "core/field/names.h"
#include "core/field/step_rows.h"

#include <algorithm>

namespace straightedge::gui {

namespace {

/// Series of a figure over the rows of a step, with the rows that their points stand for.
struct StepSeries {
  PlotSeries series;
  std::vector<std::size_t> rows;
};

void appendRow(StepSeries& to, double place, double value, std::size_t row, bool on) {
  to.series.x.append(place);
  to.series.y.append(value);
  to.series.emphasised.append(!on);
  to.rows.push_back(row);
}

} // namespace

RowFigure campaignStepFigure(const field::Campaign& campaign, field::CampaignStep step,
                             const std::vector<bool>& enabled) {
  const field::StepNeeds needs = field::needsOf(step);
  const bool chamber = step == field::CampaignStep::ProbeTemperature;
  const bool zeroField = !needs.reference && !chamber;
  RowFigure figure;
  PlotSpec& spec = figure.spec;
  spec.title = QStringLiteral("%1 as recorded").arg(stepTitle(step));
  spec.x = dataAxis(QStringLiteral("Row of the step"));
  spec.y = dataAxis(chamber     ? QStringLiteral("Chamber temperature (°C)")
                    : zeroField ? QStringLiteral("Raw reading (mT)")
                                : QStringLiteral("Raw reading (T)"));
  std::vector<StepSeries> series;
  if (chamber) {
    spec.right = dataAxis(QStringLiteral("PT100 resistance (Ω)"));
    series.push_back({pointSeries(QStringLiteral("Chamber"), SeriesColor::First), {}});
    series.push_back({pointSeries(QStringLiteral("PT100 (right axis)"), SeriesColor::Second), {}});
    series.back().series.rightAxis = true;
  } else {
    for (const field::Axis axis : field::allAxes) {
      series.push_back({pointSeries(QStringLiteral("Axis %1").arg(axisLetter(axis)), axisColor(axis)), {}});
    }
  }
  double place = 0.0;
  std::size_t unlocked = 0;
  const double scale = zeroField ? 1e3 : 1.0;
  for (std::size_t row = 0; row < campaign.rows.size(); ++row) {
    const field::CampaignRow& each = campaign.rows[row];
    if (each.step != step) {
      continue;
    }
    place += 1.0;
    if (needs.reference && !each.locked) {
      ++unlocked;
      continue;
    }
    const bool on = row >= enabled.size() || enabled[row];
    if (chamber) {
      appendRow(series[0], place, each.chamberC, row, on);
      appendRow(series[1], place, each.pt100Ohm, row, on);
      continue;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!needs.axis || (each.axis && field::indexOf(*each.axis) == axis)) {
        appendRow(series[axis], place, scale * each.rawT.at(axis), row, on);
      }
    }
  }
  for (StepSeries& each : series) {
    if (!each.rows.empty()) {
      if (!each.series.emphasised.contains(true)) {
        each.series.emphasised.clear();
      }
      spec.series.append(std::move(each.series));
      figure.rows.push_back(std::move(each.rows));
    }
  }
  spec.note = QStringLiteral("%1 rows").arg(static_cast<qlonglong>(place));
  if (unlocked > 0) {
    spec.note += QStringLiteral(", %1 without a locked reference left out").arg(unlocked);
  }
  return figure;
}

} // namespace straightedge::gui
