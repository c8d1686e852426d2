// straightedge-cli capture field: options, and how they become a run.
#pragma once

#include "core/base/error.h"

#include <CLI/CLI.hpp>

#include <functional>

namespace straightedge::cli {

/// Adds the subcommand `field` to `capture`. `onChosen` as of addCaptureCommand().
void addFieldCapture(CLI::App& capture, std::function<void(std::function<Result<void>()>)> onChosen);

} // namespace straightedge::cli
