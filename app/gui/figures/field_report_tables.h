// Tables of a field calibration that the report prints and the window copies to the clipboard.
#pragma once

#include "app/gui/figures/report_content.h"

namespace straightedge::gui {

/// Rows of every step, and of a run those left out and why.
ReportTable campaignTable(const FieldResults& results);
/// Every block: axis, rows used and left out, coefficients, what it leaves; those that are off too.
ReportTable blocksTable(const field::FieldCalibration& calibration);
/// Largest error of each order, axis by axis; cross-validated beside where known.
ReportTable ordersTable(const field::FieldCalibration& calibration);
/// Mean, sigma and peak before and after each block. `of`: percent of full scale or of the reading.
ReportTable fieldVerificationTable(const std::vector<field::VerificationRow>& rows, field::PercentOf of);
ReportTable fieldUncertaintyTable(const field::UncertaintySummary& summary);
/// Orders of the blocks against what they leave; the best ones only, and blocks left out.
ReportTable storageTable(const field::StorageComparison& comparison);
/// Coefficients of all blocks, a row per coefficient and a column per axis.
ReportTable chainTable(const field::CorrectionChain& chain);
/// S, and the angles between axes.
ReportTable axisMatrixTable(const Eigen::Matrix3d& matrix);
ReportTable axisAnglesTable(const Eigen::Matrix3d& matrix);

/// "Passed: …" or "Failed: …" with figures.
QString fieldVerdictSentence(const field::LimitReport& report);

} // namespace straightedge::gui
