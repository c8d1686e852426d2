// How the commands of straightedge-cli are put together: each file pair adds one command, none knows another.
#pragma once

#include "core/base/error.h"

#include <CLI/CLI.hpp>

#include <functional>

namespace straightedge::cli {

/// What the chosen command will do once the whole command line has been understood; gives the exit code.
using Work = std::function<Result<int>()>;

/// The registrar of a command adds a subcommand with its options to `parent` and lets the subcommand's callback put the
/// work into `work`, which outlives the parsing. The options live in a shared pointer that the work holds.
using AddCommand = void (*)(CLI::App& parent, Work& work);

} // namespace straightedge::cli
