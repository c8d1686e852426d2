#include "app/gui/figures/field_temperature_figures.h"

#include "app/gui/figures/field_figure_parts.h"
#include "app/gui/figures/figure_parts.h"

#include <cmath>
#include <limits>

namespace straightedge::gui {

namespace {

/// Rows recorded while the chamber rose and fell, the runs of each parted by gaps.
struct LoopBranches {
  PlotSeries heating = lineSeries(QStringLiteral("Heating"), SeriesColor::Second);
  PlotSeries cooling = lineSeries(QStringLiteral("Cooling"), SeriesColor::First);
};

LoopBranches branchesOf(const field::ProbeTemperatureReport& report, const Eigen::VectorXd& y, double shift) {
  LoopBranches branches;
  const Eigen::Index last = report.chamberC.size() - 1;
  for (Eigen::Index i = 0; i <= last; ++i) {
    // over several rows, so that noise of the chamber's thermometer does not decide
    constexpr Eigen::Index reach = 5;
    const double change =
        report.chamberC[std::min(last, i + reach)] - report.chamberC[std::max<Eigen::Index>(0, i - reach)];
    PlotSeries& branch = change >= 0.0 ? branches.heating : branches.cooling;
    PlotSeries& other = change >= 0.0 ? branches.cooling : branches.heating;
    if (!other.x.isEmpty() && std::isfinite(other.y.back())) {
      other.x.append(report.ohm[i]);
      other.y.append(std::numeric_limits<double>::quiet_NaN());
    }
    branch.x.append(report.ohm[i]);
    branch.y.append(y[i] + shift);
  }
  return branches;
}

QString probeNote(const field::ProbeTemperatureReport& report) {
  QString note = QStringLiteral("Standard uncertainty %1 °C").arg(peopleNumber(report.standardUncertaintyC, 2));
  if (report.hysteresisC) {
    note += QStringLiteral("; loop %1 °C wide in the mean").arg(peopleNumber(*report.hysteresisC, 2));
  }
  if (report.lagS) {
    note += QStringLiteral("; lag %1 s").arg(peopleNumber(*report.lagS, 2));
  }
  return note;
}

} // namespace

PlotSpec probeLoopFigure(const field::ProbeTemperatureReport& report, double referenceTemperatureC) {
  PlotSpec spec;
  spec.title = QStringLiteral("PT100 over the temperature sweep");
  spec.x = dataAxis(QStringLiteral("PT100 resistance (Ω)"));
  spec.y = dataAxis(QStringLiteral("Chamber temperature (°C)"));
  const LoopBranches branches = branchesOf(report, report.chamberC, referenceTemperatureC);
  const QList<double> along = evenly(report.ohm.minCoeff(), report.ohm.maxCoeff(), 2);
  const std::array<double, 2> line = {report.line.interceptC + referenceTemperatureC, report.line.slopeCPerOhm};
  spec.series = {branches.heating, branches.cooling,
                 lineSeries(QStringLiteral("Line"), SeriesColor::Reference, along, polynomialOver(line, along))};
  spec.note = QStringLiteral("%1 °C per Ω. ").arg(peopleNumber(report.line.slopeCPerOhm, 5)) + probeNote(report);
  return spec;
}

PlotSpec probeResidualFigure(const field::ProbeTemperatureReport& report, double referenceTemperatureC) {
  PlotSpec spec;
  spec.title = QStringLiteral("Hysteresis of the PT100 about its line");
  spec.x = dataAxis(QStringLiteral("Temperature on the line (°C)"));
  spec.y = dataAxis(QStringLiteral("Chamber − line (°C)"));
  LoopBranches branches = branchesOf(report, report.chamberC - report.lineC, 0.0);
  for (PlotSeries* branch : {&branches.heating, &branches.cooling}) {
    for (double& ohm : branch->x) {
      ohm = report.line.interceptC + report.line.slopeCPerOhm * ohm + referenceTemperatureC;
    }
  }
  spec.series = {branches.heating, branches.cooling};
  const QList<double> along = {report.lineC.minCoeff() + referenceTemperatureC,
                               report.lineC.maxCoeff() + referenceTemperatureC};
  const double band = 2.0 * report.standardUncertaintyC;
  for (const double edge : {band, -band}) {
    PlotSeries line = lineSeries(edge > 0.0 ? QStringLiteral("±2 standard uncertainties") : QString(),
                                 SeriesColor::Muted, along, {edge, edge});
    line.dashed = true;
    spec.series.append(line);
  }
  spec.note = probeNote(report);
  return spec;
}

PlotSpec zeroFieldFigure(const std::array<std::optional<field::ZeroFieldReport>, 3>& reports,
                         double referenceTemperatureC, ZeroFieldOver over) {
  PlotSpec spec;
  const bool probe = over == ZeroFieldOver::Probe;
  spec.title = probe ? QStringLiteral("Offset over probe temperature, in no field")
                     : QStringLiteral("Offset over electronics temperature, in no field");
  spec.x = dataAxis(probe ? probeTitle() : electronicsTitle());
  spec.y = dataAxis(QStringLiteral("Axis in no field (µT)"));
  QStringList drifts;
  QList<PlotSeries> lines;
  for (const auto& report : reports) {
    if (!report || report->temperatureC.size() == 0) {
      continue;
    }
    const QString letter = axisLetter(report->axis);
    spec.series.append(pointSeries(QStringLiteral("Axis %1").arg(letter), axisColor(report->axis),
                                   scaledList(report->temperatureC, 1.0, referenceTemperatureC),
                                   scaledList(report->valueT, 1.0 / teslaPerMicrotesla)));
    const double low = report->temperatureC.minCoeff();
    const double high = report->temperatureC.maxCoeff();
    const auto at = [&report](double t) { return (report->offsetT[0] + report->offsetT[1] * t) / teslaPerMicrotesla; };
    lines.append(lineSeries(lines.isEmpty() ? QStringLiteral("Lines fitted") : QString(), SeriesColor::Reference,
                            {low + referenceTemperatureC, high + referenceTemperatureC}, {at(low), at(high)}));
    drifts << letter + QLatin1Char(' ') + peopleNumber(report->offsetT[1] / teslaPerMicrotesla);
  }
  spec.series += lines;
  spec.note = QStringLiteral("Drift in µT/°C: ") + drifts.join(QStringLiteral(", "));
  return spec;
}

} // namespace straightedge::gui
