// What a field calibration is worth and what it costs as plots: expanded uncertainty, storage against error.
#pragma once

#include "app/gui/plots/plot_spec.h"
#include "core/field/storage.h"
#include "core/field/uncertainty_summary.h"

#include <cstdint>
#include <vector>

namespace straightedge::gui {

/// Expanded uncertainty (95 %) of each component over the field along it: at the reference temperatures, and the
/// largest over the temperatures that the campaign covers.
PlotSpec expandedUncertaintyFigure(const field::UncertaintySummary& summary);

enum class ChainCost : std::uint8_t { Coefficients, Multiplications };

/// A plot whose points stand for the comparison's choices, so that a click can find one.
struct StorageFigure {
  PlotSpec spec;
  std::vector<std::vector<std::size_t>> choices; ///< choices[series][index] into StorageComparison::choices
};

/// Largest peak that remains, over coefficients or multiplications (the error on a logarithmic scale); the choice of
/// `order` and `slopeOrder` (as fitted) is emphasised, and the best ones joined.
StorageFigure storageFigure(const field::StorageComparison& comparison, ChainCost cost, int order, int slopeOrder);

} // namespace straightedge::gui
