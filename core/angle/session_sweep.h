// Raw samples of a session -> the sweep that is calibrated or verified.
#pragma once

#include "core/angle/sweep.h"
#include "core/base/error.h"
#include "core/base/traceability.h"
#include "core/session/session.h"

#include <string>
#include <vector>

namespace straightedge::angle {

/// One row per sample, in the plan's order of points, then of arrival; of a point that was measured again only the
/// latest attempt. Temperature becomes a column where every sample has one. `source` counts the points and is else
/// empty.
Sweep sweepFromSamples(const std::vector<session::AngleSample>& samples);

struct SessionSweep {
  Sweep sweep; ///< rows switched off in the review are disabled; source: file name, SHA-256 of the canonical CSV
  Traceability traceability;
};

/// Reads a sweep out of a session file, which is not changed. Errors: those of Session::openReadOnly; Input, where the
/// session is of another kind or holds no captured sweep of that role.
Result<SessionSweep> readSessionSweep(const std::string& path, session::SweepRole role);

/// Is this a session file, by its first bytes or, where it has none, its name? Never true of "-".
bool isSessionFile(const std::string& path);

} // namespace straightedge::angle
