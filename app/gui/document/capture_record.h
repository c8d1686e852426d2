// Beside a session's raw samples: the plan they were taken with and whether it was carried out to the end. From this an
// interrupted sweep or campaign is found again after a crash and resumed with the very same plan.
#pragma once

#include "core/session/session.h"
#include "devices/capture/angle_plan.h"
#include "devices/capture/field_plan.h"

#include <QString>

#include <optional>

namespace straightedge::gui {

template <typename Plan>
struct CaptureRecordOf {
  Plan plan;
  bool finished = false; ///< everything planned was measured
  QString bench;         ///< name and instruments, one per line, as CaptureLink::describe() says them
};
using CaptureRecord = CaptureRecordOf<devices::AnglePlan>;
using FieldCaptureRecord = CaptureRecordOf<devices::FieldPlan>;

/// Kept as one JSON document of the session per role; the command line writes the same. Errors: Storage.
Result<void> writeCaptureRecord(session::Session& session, session::SweepRole role, const CaptureRecord& record);
Result<void> writeCaptureRecord(session::Session& session, session::SweepRole role, const FieldCaptureRecord& record);

/// Empty where nothing was captured, or where the session says nothing that this version understands.
std::optional<CaptureRecord> readCaptureRecord(const session::Session& session, session::SweepRole role);
std::optional<FieldCaptureRecord> readFieldCaptureRecord(const session::Session& session, session::SweepRole role);

} // namespace straightedge::gui
