// The result of a verification as one JSON object: what `angle verify --json` prints and a session keeps.
#pragma once

#include "core/angle/verification.h"
#include "core/base/traceability.h"

#include <string>

namespace straightedge::exporting {

/// `source` is the fresh sweep. An uncertainty that is not known is null. Without the lists for plots: they follow from
/// the sweep.
std::string verificationToJson(const angle::VerificationReport& report, const Traceability& traceability,
                               const SourceRecord& source);

} // namespace straightedge::exporting
