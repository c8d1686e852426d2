// `field apply`: a table of a teslameter's readings gets the columns x_T, y_T and z_T.
#pragma once

#include "app/cli/command.h"

namespace straightedge::cli {

void addFieldApplyCommand(CLI::App& parent, Work& work);

} // namespace straightedge::cli
