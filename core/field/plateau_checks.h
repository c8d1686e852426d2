// Can plateaus carry a nonlinearity at all? Private to nonlinearity.
#pragma once

#include "core/field/nonlinearity.h"

namespace straightedge::field {

/// Errors: those that fitNonlinearity() states.
Result<void> checkPlateaus(const AxisPlateaus& plateaus, const NonlinearityOptions& options, const std::string& name);

} // namespace straightedge::field
