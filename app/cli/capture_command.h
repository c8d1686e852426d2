// straightedge-cli capture angle: options, and how they become a run.
#pragma once

#include "app/cli/capture_run.h"

#include <CLI/CLI.hpp>

#include <functional>

namespace straightedge::cli {

/// Adds `capture` with its subcommand `angle` to the program. `onChosen` receives the run when the command line asks
/// for it; what that returns decides the exit code.
void addCaptureCommand(CLI::App& program, std::function<void(std::function<Result<void>()>)> onChosen);

} // namespace straightedge::cli
