#include "app/gui/figures/field_sensitivity_figures.h"

#include "app/gui/figures/field_figure_parts.h"
#include "app/gui/figures/figure_parts.h"
#include "core/field/chain_stages.h"
#include "core/field/names.h"

#include <algorithm>
#include <span>

namespace straightedge::gui {

namespace {

using field::ChainStage;

/// The rows of one axis's temperature sweeps and what the fit found in them.
struct AxisSweeps {
  const field::StepRows& rows;
  std::span<const field::FieldSweep> sweeps;
  Eigen::VectorXd temperatureC; ///< minus reference temperature
  ChainStage before = ChainStage::Offset;
};

std::span<const field::FieldSweep> sweepsOf(const field::FieldRun& run, field::Axis axis, SweptTemperature over) {
  const std::size_t place = field::indexOf(axis);
  if (over == SweptTemperature::Probe) {
    const auto& report = run.reports.sensitivity.at(place);
    return report ? std::span<const field::FieldSweep>(report->sweeps) : std::span<const field::FieldSweep>();
  }
  const auto& report = run.reports.electronicsSensitivity.at(place);
  return report ? std::span<const field::FieldSweep>(report->sweeps) : std::span<const field::FieldSweep>();
}

AxisSweeps axisSweeps(const field::FieldRun& run, field::Axis axis, SweptTemperature over) {
  const bool probe = over == SweptTemperature::Probe;
  const field::StepRows& rows =
      run.parts.of(probe ? field::CampaignStep::Sensitivity : field::CampaignStep::ElectronicsSensitivity, axis);
  const field::CorrectionChain& chain = stepwiseChain(run);
  return {rows, sweepsOf(run, axis, over),
          probe ? field::probeTemperatureC(chain, rows) : field::electronicsTemperatureC(chain, rows),
          probe ? ChainStage::Offset : ChainStage::Electronics};
}

/// Points of one sweep, in order of temperature, so that they can be joined by a line.
PlotSeries sweepSeries(const AxisSweeps& data, const field::FieldSweep& sweep, const Eigen::VectorXd& y,
                       double referenceC) {
  PlotSeries series;
  series.style = SeriesStyle::Points;
  for (Eigen::Index i = sweep.first; i < sweep.first + sweep.rows; ++i) {
    series.x.append(data.temperatureC[i] + referenceC);
    series.y.append(y[i]);
  }
  return series;
}

QString sweptTitle(SweptTemperature over) {
  return over == SweptTemperature::Probe ? probeTitle() : electronicsTitle();
}

} // namespace

PlotSpec sweepErrorsFigure(const field::FieldRun& run, field::Axis axis, SweptTemperature over) {
  PlotSpec spec;
  spec.title = QStringLiteral("Error at each locked field, axis %1").arg(axisLetter(axis));
  spec.x = dataAxis(sweptTitle(over));
  spec.y = dataAxis(QStringLiteral("Instrument − reference (µT)"));
  const AxisSweeps data = axisSweeps(run, axis, over);
  if (data.sweeps.empty()) {
    spec.note = QStringLiteral("The block is off: no usable sweeps of this axis");
    return spec;
  }
  const field::CorrectionChain& chain = stepwiseChain(run);
  const double referenceC = chain.referenceTemperatureC;
  const Eigen::VectorXd errorT = field::axisValuesT(chain, axis, data.rows, data.before) - data.rows.referenceT;
  std::vector<field::FieldSweep> ordered(data.sweeps.begin(), data.sweeps.end());
  std::ranges::sort(ordered, std::ranges::greater{}, &field::FieldSweep::referenceT);
  QList<PlotSeries> lines;
  int place = 0;
  for (const field::FieldSweep& sweep : ordered) {
    PlotSeries points = sweepSeries(data, sweep, errorT / teslaPerMicrotesla, referenceC);
    points.name = teslaText(sweep.referenceT, 2);
    points.color = seriesColor(place++);
    if (points.x.isEmpty()) {
      continue;
    }
    const auto [low, high] = std::ranges::minmax(points.x);
    const auto at = [&](double c) { return (sweep.intercept + sweep.slope * (c - referenceC)) / teslaPerMicrotesla; };
    lines.append(lineSeries(lines.isEmpty() ? QStringLiteral("Lines fitted") : QString(), SeriesColor::Reference,
                            {low, high}, {at(low), at(high)}));
    spec.series.append(points);
  }
  spec.series += lines;
  const auto steepest =
      std::ranges::max_element(ordered, {}, [](const field::FieldSweep& sweep) { return std::abs(sweep.slope); });
  spec.note = QStringLiteral("Before the block; steepest %1 µT/°C at %2")
                  .arg(peopleNumber(steepest->slope / teslaPerMicrotesla), teslaText(steepest->referenceT, 2));
  return spec;
}

namespace {

/// One axis's values at its sweeps' fields as points, and a polynomial through them.
void addOverField(PlotSpec& spec, field::Axis axis, std::span<const field::FieldSweep> sweeps,
                  double field::FieldSweep::* value, std::span<const double> coefficients, double fullScaleT) {
  PlotSeries points = pointSeries({}, axisColor(axis));
  for (const field::FieldSweep& sweep : sweeps) {
    points.x.append(sweep.valueT);
    points.y.append(sweep.*value / teslaPerMicrotesla);
  }
  const QList<double> along = evenly(-fullScaleT, fullScaleT);
  spec.series.append(lineSeries(QStringLiteral("Axis %1").arg(axisLetter(axis)), axisColor(axis), along,
                                polynomialOver(coefficients, along, 1.0 / teslaPerMicrotesla)));
  spec.series.append(points);
}

} // namespace

PlotSpec sweepSlopesFigure(const field::FieldRun& run, SweptTemperature over) {
  const bool probe = over == SweptTemperature::Probe;
  PlotSpec spec;
  spec.title = probe ? QStringLiteral("Drift with probe temperature over the field")
                     : QStringLiteral("Drift with electronics temperature over the field");
  spec.x = dataAxis(QStringLiteral("Field (T)"));
  spec.y = dataAxis(QStringLiteral("Slope of the error (µT/°C)"));
  const double fullScaleT = stepwiseChain(run).fullScaleT;
  QStringList left;
  for (const field::Axis axis : field::allAxes) {
    const auto sweeps = sweepsOf(run, axis, over);
    if (sweeps.empty()) {
      continue;
    }
    const std::size_t place = field::indexOf(axis);
    if (!probe) {
      addOverField(spec, axis, sweeps, &field::FieldSweep::slope,
                   run.reports.electronicsSensitivity.at(place)->coefficients, fullScaleT);
      continue;
    }
    const field::SensitivityReport& report = *run.reports.sensitivity.at(place);
    addOverField(spec, axis, sweeps, &field::FieldSweep::slope, report.slope, fullScaleT);
    const auto linear = std::ranges::find(report.slopeOrders, 1, &field::SlopeOrder::order);
    if (linear != report.slopeOrders.end() && report.slope.size() > 2) {
      const QList<double> along = evenly(-fullScaleT, fullScaleT, 2);
      PlotSeries line = lineSeries(QStringLiteral("%1, straight line").arg(axisLetter(axis)), axisColor(axis), along,
                                   polynomialOver(linear->coefficients, along, 1.0 / teslaPerMicrotesla));
      line.dashed = true;
      spec.series.append(line);
      const auto kept =
          std::ranges::find(report.slopeOrders, static_cast<int>(report.slope.size()) - 1, &field::SlopeOrder::order);
      if (kept != report.slopeOrders.end()) {
        left << QStringLiteral("%1 %2 and %3")
                    .arg(axisLetter(axis), peopleNumber(linear->rmsSlope / teslaPerMicrotesla, 2),
                         peopleNumber(kept->rmsSlope / teslaPerMicrotesla, 2));
      }
    }
  }
  spec.note = left.isEmpty() ? QStringLiteral("Points: one sweep of temperature each")
                             : QStringLiteral("Left by the straight line and the polynomial, rms in µT/°C: ") +
                                   left.join(QStringLiteral("; "));
  return spec;
}

PlotSpec sweepInterceptsFigure(const field::FieldRun& run) {
  PlotSpec spec;
  spec.title = QStringLiteral("Error at the reference temperature over the field");
  spec.x = dataAxis(QStringLiteral("Field (T)"));
  spec.y = dataAxis(QStringLiteral("Intercept of the error (µT)"));
  double largest = 0.0;
  for (const field::Axis axis : field::allAxes) {
    const auto& report = run.reports.sensitivity.at(field::indexOf(axis));
    if (!report) {
      continue;
    }
    addOverField(spec, axis, report->sweeps, &field::FieldSweep::intercept, report->intercept,
                 stepwiseChain(run).fullScaleT);
    for (const field::FieldSweep& sweep : report->sweeps) {
      largest = std::max(largest, std::abs(sweep.intercept));
    }
  }
  spec.note = QStringLiteral("At %1 °C; largest %2")
                  .arg(peopleNumber(stepwiseChain(run).referenceTemperatureC), microteslaText(largest));
  return spec;
}

PlotSpec blockAfterBlockFigure(const field::FieldRun& run, field::Axis axis) {
  PlotSpec spec;
  spec.x = dataAxis(probeTitle());
  spec.y = dataAxis(QStringLiteral("Error after the blocks (% of full scale)"));
  const AxisSweeps data = axisSweeps(run, axis, SweptTemperature::Probe);
  const field::CorrectionChain& chain = stepwiseChain(run);
  const auto smallest = std::ranges::min_element(data.sweeps, {}, [](const field::FieldSweep& sweep) {
    return sweep.referenceT > 0.0 ? sweep.referenceT : 1e3 - sweep.referenceT; // negative fields come last
  });
  if (smallest == data.sweeps.end()) {
    spec.title = QStringLiteral("Block after block, axis %1").arg(axisLetter(axis));
    spec.note = QStringLiteral("The block sensitivity is off: no sweeps of this axis");
    return spec;
  }
  spec.title =
      QStringLiteral("Block after block at %1, axis %2").arg(teslaText(smallest->referenceT, 2), axisLetter(axis));
  spec.right = dataAxis(QStringLiteral("Error of the raw reading (% of full scale)"));
  struct Shown {
    ChainStage stage;
    QString name;
    SeriesColor color;
  };
  const std::array<Shown, 4> stages = {
      {{ChainStage::Raw, QStringLiteral("Raw (right axis)"), SeriesColor::Muted},
       {ChainStage::Nonlinearity, QStringLiteral("After nonlinearity"), SeriesColor::Second},
       {ChainStage::Offset, QStringLiteral("After offset"), SeriesColor::Fourth},
       {ChainStage::Sensitivity, QStringLiteral("After sensitivity"), SeriesColor::First}}};
  QStringList means;
  double lowest = 0.0; // of what the blocks leave
  double highest = 0.0;
  double rawMiddle = 0.0;
  for (const Shown& shown : stages) {
    const Eigen::VectorXd errorPercent =
        (field::axisValuesT(chain, axis, data.rows, shown.stage) - data.rows.referenceT) * (100.0 / chain.fullScaleT);
    PlotSeries series = sweepSeries(data, *smallest, errorPercent, chain.referenceTemperatureC);
    series.name = shown.name;
    series.color = shown.color;
    series.rightAxis = shown.stage == ChainStage::Raw;
    spec.series.append(series);
    const auto part = errorPercent.segment(smallest->first, smallest->rows);
    means << percentText(part.mean());
    if (series.rightAxis) {
      rawMiddle = 0.5 * (part.minCoeff() + part.maxCoeff());
    } else {
      lowest = std::min(lowest, part.minCoeff());
      highest = std::max(highest, part.maxCoeff());
    }
  }
  // Both axes have the same scale, so that spreads compare, and the raw readings lie above the others.
  const double span = highest - lowest;
  spec.y.minimum = lowest - 0.1 * span;
  spec.y.maximum = highest + 1.2 * span;
  const double shift = rawMiddle - (highest + 0.6 * span);
  spec.right->minimum = *spec.y.minimum + shift;
  spec.right->maximum = *spec.y.maximum + shift;
  spec.note = QStringLiteral("Means: ") + means.join(QStringLiteral(", "));
  return spec;
}

} // namespace straightedge::gui
