// `export`: the tables of a calibration in another format.
#pragma once

#include "app/cli/command.h"

namespace straightedge::cli {

void addExportCommand(CLI::App& parent, Work& work);

} // namespace straightedge::cli
