// `angle apply`: a calibration applied to a table of readings.
#pragma once

#include "app/cli/command.h"

namespace straightedge::cli {

void addApplyCommand(CLI::App& parent, Work& work);

} // namespace straightedge::cli
