// `angle batch`: many sweeps at once, on all cores.
#pragma once

#include "app/cli/command.h"

namespace straightedge::cli {

void addBatchCommand(CLI::App& parent, Work& work);

} // namespace straightedge::cli
