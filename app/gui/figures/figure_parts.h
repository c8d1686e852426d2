// What all figures share: axes with units, colours by place, Eigen vectors as lists, names of models for people.
#pragma once

#include "app/gui/plots/plot_spec.h"
#include "core/angle/alignment.h"
#include "core/angle/model_name.h"

#include <Eigen/Core>
#include <QList>
#include <QString>

#include <string>
#include <vector>

namespace straightedge::gui {

QList<double> toList(const Eigen::VectorXd& values);
QList<double> toList(const std::vector<double>& values);

/// 0 to 360° with a tick every 45°.
PlotAxis turnAxis(const QString& title);
/// Fits the data; a 5 % margin.
PlotAxis dataAxis(const QString& title);
/// "Sensor angle (°)", or "360° − sensor angle (°)" for a sensor that runs backwards: what curves are drawn over.
QString readingTitle(angle::SensorDirection direction);

/// Colour of the n-th series beside a reference: First to Sixth, then from the beginning.
SeriesColor seriesColor(int place);
/// Colour that models of this kind and method have in every comparison, so that plots can be read side by side.
SeriesColor methodColor(angle::ModelKind kind, angle::FitMethod method);

/// "4 harmonics", "32 segments on the curve", "64 table entries, 12 bit".
QString modelTitle(const angle::ModelName& name);
/// "Harmonics", "Linear, least squares", "Lookup table, mean", …
QString methodTitle(angle::ModelKind kind, angle::FitMethod method);
/// The canonical name, e.g. "linear:32@minimax".
QString modelNameText(const angle::ModelName& name);

/// A value with unit for people: four significant digits, "0.1234°".
QString degrees(double valueDeg, int digits = 4);
QString fromText(const std::string& text);

/// Figure without data: axes and a sentence that says what is missing.
PlotSpec emptyFigure(const QString& title, const PlotAxis& x, const PlotAxis& y, const QString& note);

} // namespace straightedge::gui
