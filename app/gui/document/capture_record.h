// Beside a session's raw samples: the plan they were taken with and whether it was carried out to the end. From this an
// interrupted sweep is found again after a crash and resumed with the very same plan.
#pragma once

#include "core/session/session.h"
#include "devices/capture/angle_plan.h"

#include <QString>

#include <optional>

namespace straightedge::gui {

struct CaptureRecord {
  devices::AnglePlan plan;
  bool finished = false; ///< every planned point was measured
  QString bench;         ///< name and instruments, one per line, as BenchLink::describe() says them
};

/// Kept as one JSON document of the session per role. Errors: Storage.
Result<void> writeCaptureRecord(session::Session& session, session::SweepRole role, const CaptureRecord& record);

/// Empty where nothing was captured, or where the session says nothing that this version understands.
std::optional<CaptureRecord> readCaptureRecord(const session::Session& session, session::SweepRole role);

} // namespace straightedge::gui
