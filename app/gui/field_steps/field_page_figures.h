// The figures that the pages of a field calibration choose from: those of the report, with short names.
#pragma once

#include "app/gui/figures/field_figures.h"

#include <QList>
#include <QString>

#include <memory>
#include <span>

namespace straightedge::gui {

class FieldDocument;

/// What the document holds now; null without a fit.
std::shared_ptr<const FieldResults> resultsOf(const FieldDocument& document);
/// The figures of these topics, in the report's order; empty without a fit. Cheap: plots are made only when asked for.
QList<NamedFigure> figuresAbout(const FieldDocument& document, std::span<const FigureTopic> topics);
/// "nonlinearity-residuals-x" is "Nonlinearity residuals, x".
QString shortName(const NamedFigure& figure);
/// Place of the figure of that stem; the first where there is none any more; −1 in an empty list.
int placeOf(const QList<NamedFigure>& figures, const QString& stem);

} // namespace straightedge::gui
