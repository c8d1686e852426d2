// Whether a bench is complete in itself, before anything is opened: what a form shows beside the field.
#pragma once

#include "devices/bench/saved_bench.h"
#include "devices/instruments/profile_files.h"

namespace straightedge::devices {

/// Errors: Input (no such instrument; it cannot fill a role; the role is filled twice), Usage (a setting is wrong, and
/// what would be right).
Result<void> checkBenchInstrument(const BenchInstrument& instrument, const ProfileSet& profiles);
Result<void> checkBench(const SavedBench& bench, const ProfileSet& profiles);

} // namespace straightedge::devices
