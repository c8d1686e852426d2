// Tables for firmware and spreadsheets: one model, or a comparison, as CSV.
#pragma once

#include "core/angle/comparison.h"
#include "core/angle/model.h"
#include "core/base/error.h"

#include <string>
#include <string_view>

namespace straightedge::exporting {

/// One model; numbers read back to the same doubles. By kind:
/// - harmonic: `order,amplitude_deg,phase_rad`; the row of order 0 holds the offset with its sign (phase 0),
/// - linear: `reading_deg,correction_deg`, a row per value, the one at 0° first (the value at 360° is the first again),
/// - lut: `from_deg,to_deg,correction_deg`, a row per bin from ≤ reading < to.
/// A quantised model has the stored integers beside: `stored`, or `stored_amplitude,stored_phase` (the offset is kept
/// as it is: empty).
std::string modelTableCsv(const angle::Model& model);

/// Name of that file: "linear-32.csv".
std::string modelTableFileName(const angle::Model& model);

/// comparison.csv: `model,method,size,storage_entries,bytes,max_error_deg,rms_error_deg,max_error_65536_deg`; the last
/// one empty where there is none.
std::string comparisonCsv(const angle::Comparison& comparison);

/// Reads comparison.csv back; columns in any order. The bits of a quantised comparison are not part of the file.
/// Errors (Input, FILE:LINE): those of CsvTable; a missing column; an unknown model or method; text that is no number.
Result<angle::Comparison> comparisonFromCsv(std::string bytes, const std::string& name);

} // namespace straightedge::exporting
