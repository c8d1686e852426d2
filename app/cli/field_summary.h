// What the field commands tell on the terminal: short tables.
#pragma once

#include "core/field/calibration.h"
#include "core/field/verification.h"

#include <string>
#include <vector>

namespace straightedge::cli {

/// A row per state and axis: mean, one sigma and peak, in percent of full scale or of reading.
std::string verificationTable(const std::vector<field::VerificationRow>& rows, field::PercentOf of);

/// After `field fit`: where the data came from, a row per block with what it was fitted to and what it leaves, the
/// orders of the nonlinearity side by side, and the verification.
std::string fieldSummaryOf(const field::FieldCalibration& calibration);

} // namespace straightedge::cli
