// Runs the real straightedge-cli as a child process, as a shell would.
#pragma once

#include <functional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace straightedge::testing {

struct ChildResult {
  int code = -1; ///< exit code; 128 + signal where it was ended by one
  std::string out;
  std::string err;
};

/// `input` on standard input. `program`: another copy of it. `environment`: entries NAME=VALUE that replace ours.
ChildResult runCli(const std::vector<std::string>& arguments, const std::string& input = {},
                   const std::string& program = STRAIGHTEDGE_BINARY_DIR "/straightedge-cli",
                   const std::vector<std::string>& environment = {});

/// Who sits at the program: gets each line of its standard error as it comes, and its process; returns what is typed.
using Attendant = std::function<std::string(const std::string& line, pid_t child)>;
ChildResult runCliAttended(const std::vector<std::string>& arguments, const Attendant& attendant,
                           const std::string& program = STRAIGHTEDGE_BINARY_DIR "/straightedge-cli");

} // namespace straightedge::testing
