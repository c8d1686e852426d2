#include "app/cli/render_program.h"

#include "app/cli/scratch_folder.h"
#include "core/angle/session_sweep.h"
#include "core/base/file_output.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <spawn.h>
#include <sstream>
#include <string_view>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace straightedge::cli {

namespace {

namespace fs = std::filesystem;

bool isProgram(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored) && ::access(path.c_str(), X_OK) == 0;
}

std::optional<std::string> findStraightedge() {
  std::error_code code;
  const fs::path self = fs::read_symlink("/proc/self/exe", code);
  if (!code && isProgram(self.parent_path() / "straightedge")) {
    return (self.parent_path() / "straightedge").string();
  }
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (!folder.empty() && isProgram(fs::path(folder) / "straightedge")) {
      return (fs::path(folder) / "straightedge").string();
    }
  }
  return std::nullopt;
}

/// Our environment with Qt told to do without a display.
std::vector<std::string> environmentWithoutDisplay() {
  std::vector<std::string> entries{"QT_QPA_PLATFORM=offscreen"};
  for (char** entry = environ; *entry != nullptr; ++entry) {
    if (std::strncmp(*entry, "QT_QPA_PLATFORM=", 16) != 0) {
      entries.emplace_back(*entry);
    }
  }
  return entries;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> list;
  list.reserve(texts.size() + 1);
  for (std::string& text : texts) {
    list.push_back(text.data());
  }
  list.push_back(nullptr);
  return list;
}

/// What the program said of its end; libraries may have written before it.
std::string lastWords(const std::string& text) {
  constexpr std::string_view ownName = "straightedge: ";
  std::istringstream lines(text);
  std::string words;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(ownName)) {
      return line.substr(ownName.size());
    }
    if (words.empty() && line.find_first_not_of(" \t\r") != std::string::npos) {
      words = line;
    }
  }
  return words;
}

struct Outcome {
  int status = 0;
  std::string messages; ///< what it wrote on standard error
};

Result<Outcome> runAndListen(std::vector<std::string> arguments) {
  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) {
    return fail(ErrorKind::Storage, std::string("cannot start it: ") + std::strerror(errno), "", arguments.front());
  }
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, pipe[1], STDERR_FILENO);
  std::vector<std::string> environment = environmentWithoutDisplay();
  pid_t child = 0;
  const int started = ::posix_spawn(&child, arguments.front().c_str(), &actions, nullptr, pointers(arguments).data(),
                                    pointers(environment).data());
  posix_spawn_file_actions_destroy(&actions);
  ::close(pipe[1]);
  Outcome outcome;
  if (started == 0) {
    std::array<char, 4096> block{};
    constexpr std::size_t enough = 65536;
    for (ssize_t count = 1; count > 0 || (count < 0 && errno == EINTR);) {
      count = ::read(pipe[0], block.data(), block.size());
      if (count > 0 && outcome.messages.size() < enough) {
        outcome.messages.append(block.data(), static_cast<std::size_t>(count));
      }
    }
    while (::waitpid(child, &outcome.status, 0) < 0 && errno == EINTR) {
    }
  }
  ::close(pipe[0]);
  if (started != 0) {
    return fail(ErrorKind::Storage, std::string("cannot start it: ") + std::strerror(started),
                "install the desktop application again", arguments.front());
  }
  return outcome;
}

} // namespace

Result<void> renderWithoutDisplay(const RenderRequest& request) {
  const auto program = findStraightedge();
  if (!program) {
    return fail(
        ErrorKind::Storage,
        "the program straightedge, which draws plots and reports, is neither beside straightedge-cli nor on PATH",
        "install the desktop application, or leave out --plots and --report");
  }
  std::vector<std::string> arguments{*program, "--render", request.calibration, "--out", request.out};
  if (request.plots) {
    arguments.emplace_back("--plots");
  }
  if (request.report) {
    arguments.emplace_back("--report");
  }
  if (request.sweep) {
    arguments.insert(arguments.end(), {"--sweep", *request.sweep});
  }
  const auto outcome = runAndListen(std::move(arguments));
  if (!outcome) {
    return std::unexpected(outcome.error());
  }
  if (WIFEXITED(outcome->status) && WEXITSTATUS(outcome->status) == 0) {
    return {};
  }
  std::string how = WIFEXITED(outcome->status) ? "ended with code " + std::to_string(WEXITSTATUS(outcome->status))
                                               : "was ended by signal " + std::to_string(WTERMSIG(outcome->status));
  if (const std::string line = lastWords(outcome->messages); !line.empty()) {
    how += " (" + line + ")";
  }
  return fail(ErrorKind::Storage, "drawing plots or the report " + how,
              "everything else is written; try straightedge --render by hand", *program);
}

Result<void> renderRowsWithoutDisplay(RenderRequest request, const std::string& input, const std::string& name,
                                      const std::function<std::string()>& asCsv) {
  request.sweep = input;
  if (input != "-" && !angle::isSessionFile(input)) {
    return renderWithoutDisplay(request);
  }
  const auto scratch = ScratchFolder::create();
  if (!scratch) {
    return std::unexpected(scratch.error());
  }
  request.sweep = scratch->file(name);
  if (auto written = writeFileWhole(*request.sweep, asCsv()); !written) {
    return written;
  }
  return renderWithoutDisplay(request);
}

} // namespace straightedge::cli
