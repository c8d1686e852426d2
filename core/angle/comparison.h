// Residual error against storage: every size of every method at once.
#pragma once

#include "core/angle/model.h"
#include "core/base/job_control.h"

#include <optional>
#include <string>
#include <vector>

namespace straightedge::angle {

struct ComparisonRow {
  ModelName name;
  int storageEntries = 0;
  int bytes = 0;
  double maxErrorDeg = 0.0; ///< against the curve on the 4096 grid
  double rmsErrorDeg = 0.0;
  std::optional<double> maxErrorFineDeg; ///< on 65,536 angles; sizes above 256 only
};

struct Comparison {
  std::vector<ComparisonRow> rows; ///< grouped by kind and method, sizes ascending
};

struct ComparisonOptions {
  std::optional<int> bits; ///< every model stored as integers of so many bits
};

/// Harmonics 0 to min(64, half the distinct points) by amplitude; linear least-squares and on-curve and lookup-table
/// mean and mid-range at every size from 2 to 1024. No minimax, no fine grid: quick enough to follow a drag (≤ 50 ms).
Comparison compareQuick(const CorrectionCurve& curve, const ComparisonOptions& options = {});

/// The rest, for a background job: linear minimax at every size to 64 and powers of two to 1024, and the fine-grid
/// maxima of every row above 256 entries. Errors: Cancelled.
Result<Comparison> compareFully(const CorrectionCurve& curve, const ComparisonOptions& options, const JobControl& job);

/// Answer to "which model?": least storage that meets the target, or least error within the budget.
struct Recommendation {
  std::optional<ComparisonRow> choice;  ///< empty: nothing meets the demand
  std::vector<ComparisonRow> runnersUp; ///< best of every other kind that also meets it
  std::string sentence;                 ///< for people, with computed figures
};
Recommendation recommendForTarget(const Comparison& comparison, double targetErrorDeg);
Recommendation recommendForBudget(const Comparison& comparison, int storageEntries);

} // namespace straightedge::angle
