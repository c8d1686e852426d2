// Tables that the pages of a field calibration show and copy.
#pragma once

#include "app/gui/figures/report_content.h"
#include "core/field/field_fit.h"
#include "core/field/verification.h"

#include <set>

namespace straightedge::gui {

/// A row per axis and order of the nonlinearity: largest error, and foretold by cross-validation, percent of full
/// scale.
ReportTable fitOrdersTable(const field::FieldCalibration& calibration);
/// A row per block and axis: rows, coefficients, what the block's own fit leaves; why a block is off.
ReportTable fitBlocksTable(const field::FieldCalibration& calibration, const std::set<field::Block>& offByChoice);
/// A row per axis and state: mean, one sigma and peak in percent.
ReportTable fitStatesTable(const std::vector<field::VerificationRow>& rows, field::PercentOf of);

} // namespace straightedge::gui
