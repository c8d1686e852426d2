// What the pages of a field calibration call stages and axes, and how they write percentages.
#pragma once

#include "core/field/calibration.h"

#include <QString>

#include <optional>

namespace straightedge::gui {

QString axisWord(const std::optional<field::Axis>& axis); ///< "x"; "all" without one
QString stageWord(field::CampaignStep step, const std::optional<field::Axis>& axis,
                  const std::optional<field::Orientation>& orientation); ///< "Nonlinearity, x", "Orientation, +x"
/// Four decimals, so that columns can be read down; with a proper minus sign.
QString percentFigure(double percent);
/// Three significant digits for sentences, "0.0123 %".
QString percentPhrase(double percent);
QString withProperMinus(QString text);
/// Help page of a block: its file stem in resources/help.
QString blockHelpPage(field::Block block);

} // namespace straightedge::gui
