// What `straightedge --render` does before it draws a field calibration: the campaign beside it is calibrated again.
#pragma once

#include "app/gui/figures/field_figures.h"
#include "core/base/error.h"

#include <string>

namespace straightedge::gui {

/// `calibration` and, where `campaignFile` is not empty, what its campaign adds: the run and storage against error.
/// Errors: those of reading and fitting the campaign; Input, where it is not the one that the calibration came from.
Result<std::shared_ptr<FieldResults>> fieldResultsOf(field::FieldCalibration calibration,
                                                     const std::string& campaignFile);

} // namespace straightedge::gui
