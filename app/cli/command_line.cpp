#include "app/cli/command_line.h"

#include "app/cli/apply_command.h"
#include "app/cli/batch_command.h"
#include "app/cli/capture_command.h"
#include "app/cli/command.h"
#include "app/cli/compare_command.h"
#include "app/cli/devices_command.h"
#include "app/cli/export_command.h"
#include "app/cli/field_commands.h"
#include "app/cli/fit_command.h"
#include "app/cli/messages.h"
#include "app/cli/verify_command.h"

#include <cctype>
#include <csignal>
#include <cstdio>
#include <functional>
#include <string>
#include <utility>

namespace straightedge::cli {

namespace {

/// The commands as far as they were understood: "straightedge-cli angle fit".
std::string understoodPart(const CLI::App& program) {
  std::string text = program.get_name();
  const CLI::App* level = &program;
  while (!level->get_subcommands().empty()) {
    level = level->get_subcommands().front();
    text += " " + level->get_name();
  }
  return text;
}

/// CLI11's words as one clause in one line.
std::string clause(std::string text) {
  for (char& c : text) {
    c = c == '\n' ? ' ' : c;
  }
  while (!text.empty() && (text.back() == ' ' || text.back() == '.')) {
    text.pop_back();
  }
  if (text.size() > 1 && std::isupper(static_cast<unsigned char>(text[1])) == 0) {
    text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
  }
  return text;
}

void addCommands(CLI::App& program, Work& work) {
  CLI::App* angle = program.add_subcommand("angle", "Calibrate an angle sensor from a recorded sweep");
  angle->require_subcommand(1);
  addFitCommand(*angle, work);
  addCompareCommand(*angle, work);
  addApplyCommand(*angle, work);
  addVerifyCommand(*angle, work);
  addBatchCommand(*angle, work);
  addFieldCommands(program, work);
  addExportCommand(program, work);
  addDevicesCommand(program, work);
  addCaptureCommand(program, [&work](std::function<Result<void>()> capture) {
    work = [capture = std::move(capture)]() -> Result<int> {
      if (auto done = capture(); !done) {
        return std::unexpected(std::move(done.error()));
      }
      return 0;
    };
  });
}

/// Output that the system only accepts when the buffer is flushed may fail as late as here.
int withFlushedOutput(int code) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) {
    return code;
  }
  printError({ErrorKind::Storage, "cannot write", "check the disk that the output goes to", "standard output"});
  return exitCode(ErrorKind::Storage);
}

} // namespace

int runCommandLine(int argc, const char* const* argv) {
  std::signal(SIGXFSZ, SIG_IGN); // a size limit becomes an error of write(), with a message
  CLI::App program("Calibrates sensors: the core of Straightedge without a window.", "straightedge-cli");
  program.set_version_flag("--version", "straightedge-cli " STRAIGHTEDGE_VERSION, "Print the version and exit");
  program.set_help_flag("--help,-h", "Print this help and exit");
  program.require_subcommand(1);
  program.footer("Exit codes: 0 done, 1 verify: limit not met, 2 usage, 3 input rejected, 4 instrument, 5 output.");
  Work work;
  addCommands(program, work);
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& asked) { // --help and --version
    return withFlushedOutput(program.exit(asked));
  } catch (const CLI::ParseError& error) {
    printError({ErrorKind::Usage, clause(error.what()), "see " + understoodPart(program) + " --help", {}});
    return exitCode(ErrorKind::Usage);
  }
  const Result<int> done = work();
  if (!done) {
    std::fflush(stdout);
    printError(done.error());
    return exitCode(done.error().kind);
  }
  return withFlushedOutput(*done);
}

} // namespace straightedge::cli
