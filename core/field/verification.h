// Readings in known fields at various temperatures, through the chain: mean, one sigma and peak of the error before and
// after each block (Electronics 2020, 9, 151, section 6, Tables 2 and 3, Figures 19 to 21).
#pragma once

#include "core/base/error.h"
#include "core/field/calibration.h"
#include "core/field/step_rows.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace straightedge::field {

/// Below this share of full scale an error in percent of reading says nothing.
inline constexpr double leastOfReading = 0.05;

/// Errors of one axis row by row, for plots.
struct AxisErrors {
  Axis axis = Axis::X;
  Eigen::VectorXd referenceT, probeC, electronicsC; ///< temperatures minus reference temperature
  Eigen::VectorXd beforeT, afterT;                  ///< instrument − reference: raw, and after the axis's chain (V5)
};

struct FieldVerification {
  std::vector<VerificationRow> rows; ///< by axis, then state; states of blocks that are off are left out
  std::vector<AxisErrors> errors;    ///< of the axes that have rows
  std::size_t points = 0;
  std::size_t unlocked = 0;   ///< rows left out
  std::size_t incomplete = 0; ///< rows left out: a temperature is missing that the chain asks for
};

/// Empty where the campaign has no rows of the step verification.
FieldVerification verifyChain(const CorrectionChain& chain, const CampaignParts& parts);

/// Which percentages the limit is compared with.
enum class PercentOf : std::uint8_t { FullScale, Reading };

/// A fresh campaign against a limit.
struct LimitReport {
  FieldVerification verification;
  PercentOf of = PercentOf::FullScale;
  double limitPercent = 0.0;
  double peakPercent = 0.0; ///< largest over the axes, of the axis's own chain and of the field after the matrix
  double peakBeforePercent = 0.0;
  Axis worstAxis = Axis::X;
  bool met = false; ///< peak ≤ limit
};

/// Errors (Input, where = the campaign's name): no usable row of the step verification.
Result<LimitReport> verifyField(const CorrectionChain& chain, const Campaign& campaign, double limitPercent,
                                PercentOf of = PercentOf::FullScale);

} // namespace straightedge::field
