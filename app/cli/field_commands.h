// `field …`: everything that calibrates a three-axis teslameter. A registrar per command; none knows another.
#pragma once

#include "app/cli/command.h"

namespace straightedge::cli {

void addFieldCommands(CLI::App& program, Work& work);

} // namespace straightedge::cli
