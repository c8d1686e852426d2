#include "app/gui/figures/figure_parts.h"

#include "core/base/number_text.h"

#include <array>

namespace straightedge::gui {

using angle::FitMethod;
using angle::ModelKind;

QList<double> toList(const Eigen::VectorXd& values) { return {values.begin(), values.end()}; }

QList<double> toList(const std::vector<double>& values) { return {values.begin(), values.end()}; }

PlotAxis turnAxis(const QString& title) {
  PlotAxis axis;
  axis.title = title;
  axis.minimum = 0.0;
  axis.maximum = 360.0;
  axis.tickStep = 45.0;
  return axis;
}

PlotAxis dataAxis(const QString& title) {
  PlotAxis axis;
  axis.title = title;
  return axis;
}

QString readingTitle(angle::SensorDirection direction) {
  return direction == angle::SensorDirection::Decreasing ? QStringLiteral("360° − sensor angle (°)")
                                                         : QStringLiteral("Sensor angle (°)");
}

SeriesColor seriesColor(int place) {
  static constexpr std::array colors{SeriesColor::First,  SeriesColor::Second, SeriesColor::Third,
                                     SeriesColor::Fourth, SeriesColor::Fifth,  SeriesColor::Sixth};
  return colors.at(static_cast<std::size_t>(place) % colors.size());
}

SeriesColor methodColor(ModelKind kind, FitMethod method) {
  if (kind == ModelKind::Harmonic) {
    return SeriesColor::First;
  }
  if (kind == ModelKind::LookupTable) {
    return method == FitMethod::MidRange ? SeriesColor::Fifth : SeriesColor::Third;
  }
  switch (method) {
  case FitMethod::OnCurve:
    return SeriesColor::Fourth;
  case FitMethod::Minimax:
    return SeriesColor::Sixth;
  default:
    return SeriesColor::Second;
  }
}

QString modelTitle(const angle::ModelName& name) {
  QString title = QString::number(name.size);
  switch (name.kind) {
  case ModelKind::Harmonic:
    title += name.size == 1 ? QStringLiteral(" harmonic") : QStringLiteral(" harmonics");
    break;
  case ModelKind::Linear:
    title += QStringLiteral(" segments");
    break;
  case ModelKind::LookupTable:
    title += QStringLiteral(" table entries");
    break;
  }
  switch (name.method) {
  case FitMethod::Ordered:
    title += QStringLiteral(" in order");
    break;
  case FitMethod::OnCurve:
    title += QStringLiteral(" on the curve");
    break;
  case FitMethod::Minimax:
    title += QStringLiteral(", minimax");
    break;
  case FitMethod::MidRange:
    title += QStringLiteral(", mid-range");
    break;
  case FitMethod::ByAmplitude:
  case FitMethod::LeastSquares:
  case FitMethod::Mean:
    break;
  }
  if (name.bits) {
    title += QStringLiteral(", %1 bit").arg(*name.bits);
  }
  return title;
}

QString methodTitle(ModelKind kind, FitMethod method) {
  switch (kind) {
  case ModelKind::Harmonic:
    return method == FitMethod::Ordered ? QStringLiteral("Harmonics in order") : QStringLiteral("Harmonics");
  case ModelKind::Linear:
    return method == FitMethod::OnCurve   ? QStringLiteral("Linear, on the curve")
           : method == FitMethod::Minimax ? QStringLiteral("Linear, minimax")
                                          : QStringLiteral("Linear, least squares");
  case ModelKind::LookupTable:
    return method == FitMethod::MidRange ? QStringLiteral("Lookup table, mid-range")
                                         : QStringLiteral("Lookup table, mean");
  }
  return {};
}

QString modelNameText(const angle::ModelName& name) { return QString::fromStdString(name.text()); }

QString degrees(double valueDeg, int digits) {
  QString text = QString::fromStdString(formatForPeople(valueDeg, digits)) + QChar(0x00b0);
  return text.replace(QLatin1Char('-'), QChar(0x2212)); // the axes' minus sign
}

QString fromText(const std::string& text) { return QString::fromStdString(text); }

PlotSpec emptyFigure(const QString& title, const PlotAxis& x, const PlotAxis& y, const QString& note) {
  PlotSpec spec;
  spec.title = title;
  spec.x = x;
  spec.y = y;
  spec.note = note;
  return spec;
}

} // namespace straightedge::gui
