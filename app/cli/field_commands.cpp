#include "app/cli/field_commands.h"

#include "app/cli/field_apply_command.h"
#include "app/cli/field_fit_command.h"
#include "app/cli/field_verify_command.h"

namespace straightedge::cli {

void addFieldCommands(CLI::App& program, Work& work) {
  CLI::App* field = program.add_subcommand("field", "Calibrate a three-axis teslameter from a recorded campaign");
  field->require_subcommand(1);
  addFieldFitCommand(*field, work);
  addFieldApplyCommand(*field, work);
  addFieldVerifyCommand(*field, work);
}

} // namespace straightedge::cli
