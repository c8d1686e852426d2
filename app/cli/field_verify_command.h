// `field verify`: a campaign's verification rows through a calibration, against a limit.
#pragma once

#include "app/cli/command.h"

namespace straightedge::cli {

void addFieldVerifyCommand(CLI::App& parent, Work& work);

} // namespace straightedge::cli
