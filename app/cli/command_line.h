// The command line as a whole: all commands, errors as one line, exit codes.
#pragma once

namespace straightedge::cli {

/// Runs straightedge-cli and gives its exit code. Results go to standard output, messages to standard error.
int runCommandLine(int argc, const char* const* argv);

} // namespace straightedge::cli
