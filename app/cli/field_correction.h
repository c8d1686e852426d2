// Readings of a three-axis teslameter: every row gets the columns x_T, y_T and z_T.
#pragma once

#include "app/cli/block_correction.h"
#include "core/field/chain.h"

namespace straightedge::cli {

/// The columns pt100_ohm, electronics_C, raw_x_T, raw_y_T and raw_z_T in any order; a temperature that no block of the
/// chain needs may be missing. Without a header: exactly these five.
/// Errors when it meets the readings: those of firstReadings(); a column is missing (and which block needs it); a
/// column that is to be added is there already. A row's errors: a cell that is no finite number.
MakeCorrection fieldCorrection(const field::CorrectionChain& chain, const field::AppliedChain& applied);

} // namespace straightedge::cli
