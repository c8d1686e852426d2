// `angle verify`: a fresh sweep against a limit; exit code 0 if it is met, 1 if not.
#pragma once

#include "app/cli/command.h"

namespace straightedge::cli {

void addVerifyCommand(CLI::App& parent, Work& work);

} // namespace straightedge::cli
