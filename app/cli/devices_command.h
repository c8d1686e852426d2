// straightedge-cli devices
#pragma once

#include "app/cli/command.h"

namespace straightedge::cli {

void addDevicesCommand(CLI::App& parent, Work& work);

} // namespace straightedge::cli
