// A capture from opening its bench to what is said at its end, whatever is captured.
#pragma once

#include "app/cli/bench_source.h"
#include "app/cli/capture_options.h"
#include "app/cli/capture_watch.h"

#include <functional>

namespace straightedge::cli {

/// Finds and opens the bench, records its dialogues where that is asked for, and runs `capture` on it. Signals are held
/// back meanwhile. Errors: of the bench, Storage (dialogues), those of `capture`.
Result<void> runOnBench(const CaptureOptions& options,
                        const std::function<Result<void>(BenchSource&, CaptureWatch&)>& capture);

} // namespace straightedge::cli
