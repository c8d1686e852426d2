// Many sweeps calibrated on all cores; what comes out does not depend on how many.
#pragma once

#include "app/cli/batch_inputs.h"
#include "core/angle/calibration.h"
#include "core/base/error.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace straightedge::cli {

struct BatchOptions {
  angle::CalibrationOptions calibration;
  Traceability traceability;
  std::string created; ///< one time stamp for the whole batch
  std::string out;     ///< folder, made already
  unsigned jobs = 1;
};

/// Of one input, in the order of the inputs.
struct BatchOutcome {
  std::string summaryRows;      ///< lines of summary.csv
  std::optional<Error> problem; ///< rejected (Input), or the result could not be written (Storage)
  std::size_t warnings = 0;
};

/// `progress` (done, rejected) is called in the calling thread, a few times a second. After a Storage problem the
/// inputs not yet begun are left out. Writes out/NAME.json for every input that is accepted.
std::vector<BatchOutcome> runBatch(const std::vector<BatchInput>& inputs, const BatchOptions& options,
                                   const std::function<void(std::size_t done, std::size_t rejected)>& progress);

/// `file,result,model,storage_entries,bytes,points,max_curve_deg,…,error`: a row per input and model; a rejected input
/// has one row without a model, with the reason under `error`.
std::string summaryHeader();

} // namespace straightedge::cli
