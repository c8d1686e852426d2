// Nonlinearity of the axes as plots (Electronics 2020, 9, 151, Figures 5 and 6, Table 1).
#pragma once

#include "app/gui/plots/plot_spec.h"
#include "core/field/calibration.h"
#include "core/field/nonlinearity.h"

#include <vector>

namespace straightedge::gui {

/// Figure 5: instrument − reference in percent of full scale at every plateau, orders side by side. Orders whose error
/// is many times that of the chosen one are switched off in the legend: on one scale they would hide the others.
PlotSpec orderResidualsFigure(const field::NonlinearityReport& report);

/// Table 1 as a plot: largest error of each order, and what a cross-validated fit foretells, percent of full scale.
PlotSpec largestErrorsFigure(const std::vector<field::OrderError>& orders, int chosen);

/// Figure 6: reference over raw reading at the plateaus with the polynomial through them, and what it leaves.
PlotSpec plateauFitFigure(const field::NonlinearityReport& report);

} // namespace straightedge::gui
