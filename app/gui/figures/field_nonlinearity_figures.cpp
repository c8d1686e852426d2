#include "app/gui/figures/field_nonlinearity_figures.h"

#include "app/gui/figures/field_figure_parts.h"
#include "app/gui/figures/figure_parts.h"

#include <algorithm>

namespace straightedge::gui {

namespace {

/// Reference fields in ascending order, and where each is in the report.
std::vector<Eigen::Index> byReference(const Eigen::VectorXd& referenceT) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(referenceT.size()));
  for (std::size_t i = 0; i < order.size(); ++i) {
    order[i] = static_cast<Eigen::Index>(i);
  }
  std::ranges::sort(order, {}, [&referenceT](Eigen::Index i) { return referenceT[i]; });
  return order;
}

PlotSeries orderSeries(const field::OrderResult& result, const Eigen::VectorXd& referenceT, int chosen) {
  PlotSeries series;
  series.name = result.order == chosen ? QStringLiteral("Order %1, chosen").arg(result.order)
                                       : QStringLiteral("Order %1").arg(result.order);
  series.color = result.order == 1 ? SeriesColor::Muted : seriesColor(result.order - 2);
  series.style = result.order == chosen ? SeriesStyle::LineAndPoints : SeriesStyle::Line;
  for (const Eigen::Index i : byReference(referenceT)) {
    series.x.append(referenceT[i]);
    series.y.append(result.errorPercent[i]);
  }
  return series;
}

} // namespace

PlotSpec orderResidualsFigure(const field::NonlinearityReport& report) {
  PlotSpec spec;
  spec.title = QStringLiteral("What each order leaves, axis %1").arg(axisLetter(report.axis));
  spec.x = dataAxis(fieldTitle());
  spec.y = dataAxis(QStringLiteral("Error (% of full scale)"));
  const Eigen::VectorXd referenceT = report.plateaus.referenceT();
  const auto chosen = std::ranges::find(report.orders, report.order, &field::OrderResult::order);
  constexpr double onOneScale = 20.0;
  QStringList largest;
  for (const field::OrderResult& result : report.orders) {
    PlotSeries series = orderSeries(result, referenceT, report.order);
    series.visible = chosen == report.orders.end() || result.maxErrorPercent <= onOneScale * chosen->maxErrorPercent;
    if (!series.visible) {
      largest << QStringLiteral("order %1: %2").arg(result.order).arg(percentText(result.maxErrorPercent));
    }
    spec.series.append(series);
  }
  spec.note =
      QStringLiteral("%1 plateaus of %2 rows each").arg(report.plateaus.plateaus.size()).arg(report.plateaus.rowsEach);
  if (!largest.isEmpty()) {
    spec.note += QStringLiteral("; too large for this scale, off: ") + largest.join(QStringLiteral(", "));
  }
  return spec;
}

PlotSpec largestErrorsFigure(const std::vector<field::OrderError>& orders, int chosen) {
  PlotSpec spec;
  spec.title = QStringLiteral("Largest error of each order");
  spec.x = dataAxis(QStringLiteral("Order of the polynomial"));
  spec.x.minimum = field::lowestOrder - 0.5;
  spec.x.maximum = field::highestOrder + 0.5;
  spec.x.tickStep = 1.0;
  spec.y = dataAxis(QStringLiteral("Largest error (% of full scale)"));
  spec.y.logarithmic = true;
  QStringList atChosen;
  for (const field::Axis axis : field::allAxes) {
    PlotSeries fitted = lineSeries(QStringLiteral("Axis %1").arg(axisLetter(axis)), axisColor(axis));
    fitted.style = SeriesStyle::LineAndPoints;
    PlotSeries foretold = lineSeries(QStringLiteral("%1, cross-validated").arg(axisLetter(axis)), axisColor(axis));
    foretold.dashed = true;
    for (const field::OrderError& order : orders) {
      if (order.axis != axis) {
        continue;
      }
      fitted.x.append(order.order);
      fitted.y.append(order.maxErrorPercent);
      if (order.crossMaxPercent) {
        foretold.x.append(order.order);
        foretold.y.append(*order.crossMaxPercent);
      }
      if (order.order == chosen) {
        atChosen << axisLetter(axis) + QLatin1Char(' ') + percentText(order.maxErrorPercent);
      }
    }
    if (!fitted.x.isEmpty()) {
      spec.series.append(fitted);
    }
    if (!foretold.x.isEmpty()) {
      spec.series.append(foretold);
    }
  }
  if (!atChosen.isEmpty()) {
    spec.note = QStringLiteral("Order %1: ").arg(chosen) + atChosen.join(QStringLiteral(", "));
  }
  return spec;
}

PlotSpec plateauFitFigure(const field::NonlinearityReport& report) {
  PlotSpec spec;
  spec.title = QStringLiteral("Plateaus and fit of order %1, axis %2").arg(report.order).arg(axisLetter(report.axis));
  spec.x = dataAxis(QStringLiteral("Raw reading (T)"));
  spec.y = dataAxis(fieldTitle());
  spec.right = dataAxis(QStringLiteral("Fit − reference (µT)"));
  const Eigen::VectorXd rawT = report.plateaus.rawT(report.axis);
  const Eigen::VectorXd referenceT = report.plateaus.referenceT();
  PlotSeries residual = lineSeries(QStringLiteral("What the fit leaves (right axis)"), SeriesColor::Second);
  residual.rightAxis = true;
  for (const Eigen::Index i : byReference(referenceT)) {
    residual.x.append(rawT[i]);
    residual.y.append((polynomialAt(report.coefficients, rawT[i]) - referenceT[i]) / teslaPerMicrotesla);
  }
  const QList<double> along = evenly(rawT.minCoeff(), rawT.maxCoeff());
  spec.series = {pointSeries(QStringLiteral("Plateau means"), SeriesColor::First, scaledList(rawT, 1.0),
                             scaledList(referenceT, 1.0)),
                 lineSeries(QStringLiteral("Polynomial of order %1").arg(report.order), SeriesColor::Reference, along,
                            polynomialOver(report.coefficients, along)),
                 residual};
  spec.note = QStringLiteral("Largest error %1 before, %2 after")
                  .arg(percentText(report.beforePercent), microteslaText(report.block.residuals.largest));
  return spec;
}

} // namespace straightedge::gui
