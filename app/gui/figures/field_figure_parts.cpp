#include "app/gui/figures/field_figure_parts.h"

#include "core/base/number_text.h"
#include "core/field/names.h"

#include <algorithm>

namespace straightedge::gui {

QString axisLetter(field::Axis axis) {
  const std::string_view name = field::axisName(axis);
  return QString::fromLatin1(name.data(), static_cast<qsizetype>(name.size()));
}

SeriesColor axisColor(field::Axis axis) {
  switch (axis) {
  case field::Axis::X:
    return SeriesColor::First;
  case field::Axis::Y:
    return SeriesColor::Second;
  case field::Axis::Z:
    break;
  }
  return SeriesColor::Third;
}

QString peopleNumber(double value, int digits) {
  return QString::fromStdString(formatForPeople(value, digits)).replace(QLatin1Char('-'), QChar(0x2212));
}

QString percentText(double percent, int digits) { return peopleNumber(percent, digits) + QStringLiteral(" %"); }

QString microteslaText(double tesla, int digits) {
  return peopleNumber(tesla / teslaPerMicrotesla, digits) + QStringLiteral(" µT");
}

QString teslaText(double tesla, int digits) { return peopleNumber(tesla, digits) + QStringLiteral(" T"); }

const field::CorrectionChain& stepwiseChain(const field::FieldRun& run) {
  return run.joint ? run.joint->stepwiseChain : run.result.chain;
}

PlotSeries pointSeries(const QString& name, SeriesColor color, QList<double> x, QList<double> y) {
  PlotSeries series = lineSeries(name, color, std::move(x), std::move(y));
  series.style = SeriesStyle::Points;
  return series;
}

PlotSeries lineSeries(const QString& name, SeriesColor color, QList<double> x, QList<double> y) {
  PlotSeries series;
  series.name = name;
  series.color = color;
  series.x = std::move(x);
  series.y = std::move(y);
  return series;
}

QList<double> evenly(double low, double high, int count) {
  QList<double> values;
  for (int i = 0; i < count; ++i) {
    values.append(low + (high - low) * i / std::max(1, count - 1));
  }
  return values;
}

double polynomialAt(std::span<const double> coefficients, double x) {
  double value = 0.0;
  for (std::size_t i = coefficients.size(); i-- > 0;) {
    value = value * x + coefficients[i];
  }
  return value;
}

QList<double> polynomialOver(std::span<const double> coefficients, const QList<double>& x, double scale) {
  QList<double> values;
  for (const double at : x) {
    values.append(scale * polynomialAt(coefficients, at));
  }
  return values;
}

QList<double> scaledList(const Eigen::VectorXd& values, double scale, double shift) {
  QList<double> list;
  list.reserve(values.size());
  for (const double value : values) {
    list.append(scale * value + shift);
  }
  return list;
}

QString probeTitle() { return QStringLiteral("Probe temperature (°C)"); }

QString electronicsTitle() { return QStringLiteral("Electronics temperature (°C)"); }

QString fieldTitle() { return QStringLiteral("Reference field (T)"); }

} // namespace straightedge::gui
