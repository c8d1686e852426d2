// Residual error against storage, all methods in one plot.
#pragma once

#include "app/gui/plots/plot_spec.h"
#include "core/angle/comparison.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace straightedge::gui {

enum class ErrorMeasure : std::uint8_t { Maximum, Rms };
enum class StorageMeasure : std::uint8_t { Entries, Bytes };

struct ComparisonFigureOptions {
  ErrorMeasure error = ErrorMeasure::Maximum;
  StorageMeasure storage = StorageMeasure::Entries;
  std::optional<angle::ModelName> selected = std::nullopt; ///< its point is emphasised
  std::optional<double> targetErrorDeg = std::nullopt;     ///< guide "target"
  std::optional<int> budgetEntries = std::nullopt;         ///< guide "budget"
  std::optional<double> leaveOneOutDeg = std::nullopt; ///< guide "data": no claim below it is supported by the points
  std::optional<int> bits = std::nullopt;              ///< for bytes of the budget
};

/// A plot whose points stand for rows of the comparison.
struct ComparisonFigure {
  PlotSpec spec;
  std::vector<std::vector<std::size_t>> rows; ///< rows[series][index] into Comparison::rows
};

inline constexpr const char* targetGuide = "target";
inline constexpr const char* budgetGuide = "budget";

ComparisonFigure comparisonFigure(const angle::Comparison& comparison, const ComparisonFigureOptions& options);

/// Storage axis value of a budget in entries, and back (whole entries, at least 1).
double budgetOnAxis(int entries, StorageMeasure storage, std::optional<int> bits);
int budgetFromAxis(double value, StorageMeasure storage, std::optional<int> bits);

} // namespace straightedge::gui
