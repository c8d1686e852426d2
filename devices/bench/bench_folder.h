// The benches a user has saved.
#pragma once

#include "core/base/error.h"

#include <string>
#include <vector>

namespace straightedge::devices {

/// Names of the benches in the user's folder, in order; none where there is no folder yet. Whether each can be read is
/// not looked at. Any thread.
std::vector<std::string> savedBenchNames();

/// Errors: Instrument (there is no such bench), Storage (it cannot be deleted).
Result<void> deleteBench(const std::string& name);

} // namespace straightedge::devices
