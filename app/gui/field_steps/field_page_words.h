// What the pages of a field calibration call states, stages and axes, and how they write percentages.
#pragma once

#include "core/field/calibration.h"

#include <QString>

#include <optional>

namespace straightedge::gui {

QString stateWord(field::VerifiedState state);            ///< "After sensitivity"
QString axisWord(const std::optional<field::Axis>& axis); ///< "x"; "all" without one
QString stageWord(field::CampaignStep step, const std::optional<field::Axis>& axis,
                  const std::optional<field::Orientation>& orientation); ///< "Nonlinearity, x", "Orientation, +x"
/// Four decimals, so that columns can be read down; with a proper minus sign.
QString percentFigure(double percent);
/// Three significant digits for sentences, "0.0123 %".
QString percentPhrase(double percent);
/// "12.3 µT", or "0.0123 °C" for the probe's temperature.
QString residualFigure(field::Block block, double value);
QString withProperMinus(QString text);

} // namespace straightedge::gui
