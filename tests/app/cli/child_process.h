// Runs the real straightedge-cli as a child process, as a shell would.
#pragma once

#include <string>
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

} // namespace straightedge::testing
