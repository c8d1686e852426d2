// What the figures of a field calibration share: names and colours of axes, temperatures, polynomials as lines.
#pragma once

#include "app/gui/plots/plot_spec.h"
#include "core/field/calibration.h"
#include "core/field/field_fit.h"

#include <Eigen/Core>
#include <QList>
#include <QString>

#include <span>

namespace straightedge::gui {

inline constexpr double teslaPerMicrotesla = 1e-6;

/// "x" as in files and messages.
QString axisLetter(field::Axis axis);
/// The colour that an axis has in every figure.
SeriesColor axisColor(field::Axis axis);

/// For people, with a proper minus sign.
QString peopleNumber(double value, int digits = 3);
QString percentText(double percent, int digits = 3); ///< "0.0120 %"
QString microteslaText(double tesla, int digits = 3);
QString teslaText(double tesla, int digits = 3); ///< "−0.300 T"

/// The chain that the reports of the blocks belong to: fitted step by step, whatever the method.
const field::CorrectionChain& stepwiseChain(const field::FieldRun& run);

PlotSeries pointSeries(const QString& name, SeriesColor color, QList<double> x = {}, QList<double> y = {});
PlotSeries lineSeries(const QString& name, SeriesColor color, QList<double> x = {}, QList<double> y = {});

/// `count` values from `low` to `high`, both included.
QList<double> evenly(double low, double high, int count = 121);
/// A polynomial in ascending powers.
double polynomialAt(std::span<const double> coefficients, double x);
QList<double> polynomialOver(std::span<const double> coefficients, const QList<double>& x, double scale = 1.0);
/// scale·value + shift of every element.
QList<double> scaledList(const Eigen::VectorXd& values, double scale, double shift = 0.0);

QString probeTitle();       ///< axis title "Probe temperature (°C)"
QString electronicsTitle(); ///< axis title "Electronics temperature (°C)"
QString fieldTitle();       ///< axis title "Reference field (T)"

} // namespace straightedge::gui
