#include "app/gui/figures/field_temperature_figures.h"

#include "app/gui/figures/field_figure_parts.h"
#include "app/gui/figures/figure_parts.h"

#include <cmath>
#include <limits>

namespace straightedge::gui {

namespace {

/// Rows recorded while the chamber rose and fell, the runs of each parted by gaps. Rows at a standstill go with the run
/// before.
struct LoopBranches {
  PlotSeries heating = lineSeries(QStringLiteral("Heating"), SeriesColor::Second);
  PlotSeries cooling = lineSeries(QStringLiteral("Cooling"), SeriesColor::First);
};

LoopBranches branchesOf(const field::ProbeTemperatureReport& report, const Eigen::VectorXd& x,
                        const Eigen::VectorXd& y) {
  LoopBranches branches;
  bool heats = true;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const int direction = report.directions[static_cast<std::size_t>(i)];
    heats = direction == 0 ? heats : direction > 0;
    PlotSeries& branch = heats ? branches.heating : branches.cooling;
    PlotSeries& other = heats ? branches.cooling : branches.heating;
    if (!other.x.isEmpty() && std::isfinite(other.y.back())) {
      other.x.append(x[i]);
      other.y.append(std::numeric_limits<double>::quiet_NaN());
    }
    branch.x.append(x[i]);
    branch.y.append(y[i]);
  }
  return branches;
}

QString probeNote(const field::ProbeTemperatureReport& report) {
  QStringList parts;
  if (report.hysteresisC) {
    QString loop = QStringLiteral("Loop %1 °C wide as recorded").arg(peopleNumber(*report.hysteresisC, 2));
    if (report.lagS && report.loopLeftC) {
      loop += QStringLiteral(", %1 °C with the lag of %2 s taken away")
                  .arg(peopleNumber(*report.loopLeftC, 2), peopleNumber(*report.lagS, 3));
    }
    parts << loop;
  }
  parts << QStringLiteral("Standard uncertainty %1 °C").arg(peopleNumber(report.standardUncertaintyC, 2));
  return parts.join(QStringLiteral(". "));
}

} // namespace

PlotSpec probeLoopFigure(const field::ProbeTemperatureReport& report, double referenceTemperatureC) {
  PlotSpec spec;
  spec.title = QStringLiteral("PT100 over the temperature sweep");
  spec.x = dataAxis(QStringLiteral("PT100 resistance (Ω)"));
  spec.y = dataAxis(QStringLiteral("Chamber temperature (°C)"));
  const LoopBranches branches = branchesOf(report, report.ohm, report.chamberC.array() + referenceTemperatureC);
  const QList<double> along = evenly(report.ohm.minCoeff(), report.ohm.maxCoeff(), 2);
  const std::array<double, 2> line = {report.line.interceptC + referenceTemperatureC, report.line.slopeCPerOhm};
  spec.series = {branches.heating, branches.cooling};
  if (report.lagS) {
    spec.series.append(pointSeries(QStringLiteral("As the probe felt it, behind the lag"), SeriesColor::Third,
                                   scaledList(report.ohm, 1.0), scaledList(report.feltC, 1.0, referenceTemperatureC)));
  }
  spec.series.append(lineSeries(QStringLiteral("Line"), SeriesColor::Reference, along, polynomialOver(line, along)));
  spec.note = QStringLiteral("%1 °C per Ω. ").arg(peopleNumber(report.line.slopeCPerOhm, 5)) + probeNote(report);
  return spec;
}

PlotSpec probeResidualFigure(const field::ProbeTemperatureReport& report, double referenceTemperatureC) {
  PlotSpec spec;
  spec.title = report.lagS ? QStringLiteral("What remains about the PT100's line, the lag taken away")
                           : QStringLiteral("Hysteresis of the PT100 about its line");
  spec.x = dataAxis(QStringLiteral("Temperature on the line (°C)"));
  spec.y = dataAxis(report.lagS ? QStringLiteral("Chamber behind the lag − line (°C)")
                                : QStringLiteral("Chamber − line (°C)"));
  const LoopBranches branches =
      branchesOf(report, report.lineC.array() + referenceTemperatureC, report.feltC - report.lineC);
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
