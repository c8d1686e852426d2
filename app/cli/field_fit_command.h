// `field fit`: a campaign becomes DIR/calibration.json and tables.
#pragma once

#include "app/cli/command.h"

namespace straightedge::cli {

void addFieldFitCommand(CLI::App& parent, Work& work);

} // namespace straightedge::cli
