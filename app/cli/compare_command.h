// `angle compare`: every way of storing the correction, with what it costs and leaves: DIR/comparison.csv.
#pragma once

#include "app/cli/command.h"

namespace straightedge::cli {

void addCompareCommand(CLI::App& parent, Work& work);

} // namespace straightedge::cli
