// When a result was made.
#pragma once

#include <chrono>
#include <string>

namespace straightedge {

/// ISO 8601 in UTC, whole seconds: "2026-03-01T09:30:00Z".
std::string isoUtc(std::chrono::sys_seconds time);

/// isoUtc() of now; of SOURCE_DATE_EPOCH (reproducible-builds.org) where that is set, so that a run can be repeated
/// byte for byte.
std::string timeStampNow();

} // namespace straightedge
