#include "app/cli/field_commands.h"

namespace straightedge::cli {

void addFieldCommands(CLI::App& program, Work& /*work*/) {
  CLI::App* field = program.add_subcommand("field", "Calibrate a three-axis teslameter from a recorded campaign");
  field->require_subcommand(1);
}

} // namespace straightedge::cli
