// What gives a user access to instruments on USB, said so that it works from wherever the program was started.
#pragma once

#include <filesystem>
#include <string>

namespace straightedge::devices {

/// `program`: path of the running program. Where it lies below a source tree, as every program that was built does, the
/// command that installs the udev rules, with its full path; else the rules' file and where it belongs. Any thread.
std::string accessRemedy(const std::filesystem::path& program);

const std::string& accessRemedy(); ///< of this program

} // namespace straightedge::devices
