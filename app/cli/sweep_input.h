// A sweep for the commands that take one: from a CSV file, or out of a session.
#pragma once

#include "core/angle/session_sweep.h"
#include "core/base/error.h"

#include <string>

namespace straightedge::cli {

/// `path` is a CSV file, "-" for standard input, or a session file, recognised by its content; then `role` says which
/// of its sweeps is meant, and what the session knows of device, operator and reference comes along. Errors: those of
/// readSweepCsv() and readSessionSweep().
Result<angle::SessionSweep> loadSweep(const std::string& path, session::SweepRole role);

/// `given` on the command line, with the session's entries where nothing was given.
Traceability completed(Traceability given, const Traceability& fromSession);

} // namespace straightedge::cli
