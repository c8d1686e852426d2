// `angle fit`: a sweep becomes DIR/calibration.json and a table per model.
#pragma once

#include "app/cli/command.h"

namespace straightedge::cli {

void addFitCommand(CLI::App& parent, Work& work);

} // namespace straightedge::cli
