#include "tests/app/cli/child_process.h"

#include "tests/core/base/temporary_folder.h"

#include <array>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace straightedge::testing {

namespace {

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> list;
  for (std::string& text : texts) {
    list.push_back(text.data());
  }
  list.push_back(nullptr);
  return list;
}

std::vector<std::string> merged(const std::vector<std::string>& replacements) {
  std::vector<std::string> entries = replacements;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string name = std::string(*entry).substr(0, std::string(*entry).find('=') + 1);
    bool replaced = false;
    for (const std::string& replacement : replacements) {
      replaced = replaced || replacement.starts_with(name);
    }
    if (!replaced) {
      entries.emplace_back(*entry);
    }
  }
  return entries;
}

} // namespace

ChildResult runCli(const std::vector<std::string>& arguments, const std::string& input, const std::string& program,
                   const std::vector<std::string>& environment) {
  // Files instead of pipes: no side can wait for the other.
  const TemporaryFolder folder;
  folder.write("in", input);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, folder.file("in").c_str(), O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, folder.file("out").c_str(), O_WRONLY | O_CREAT, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, folder.file("err").c_str(), O_WRONLY | O_CREAT, 0600);
  std::vector<std::string> all{program};
  all.insert(all.end(), arguments.begin(), arguments.end());
  std::vector<std::string> entries = merged(environment);
  pid_t child = 0;
  const int started =
      ::posix_spawn(&child, program.c_str(), &actions, nullptr, pointers(all).data(), pointers(entries).data());
  posix_spawn_file_actions_destroy(&actions);
  ChildResult result;
  int status = 0;
  if (started != 0 || ::waitpid(child, &status, 0) != child) {
    result.err = std::string("cannot start ") + program + ": " + std::strerror(started);
    return result;
  }
  result.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  result.out = folder.read("out");
  result.err = folder.read("err");
  return result;
}

ChildResult runCliAttended(const std::vector<std::string>& arguments, const Attendant& attendant,
                           const std::string& program) {
  ::signal(SIGPIPE, SIG_IGN); // the program may end while it is typed to
  const TemporaryFolder folder;
  std::array<int, 2> typed{};
  std::array<int, 2> said{};
  ChildResult result;
  if (::pipe2(typed.data(), O_CLOEXEC) != 0 || ::pipe2(said.data(), O_CLOEXEC) != 0) {
    result.err = "no pipes";
    return result;
  }
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, typed[0], STDIN_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, folder.file("out").c_str(), O_WRONLY | O_CREAT, 0600);
  posix_spawn_file_actions_adddup2(&actions, said[1], STDERR_FILENO);
  std::vector<std::string> all{program};
  all.insert(all.end(), arguments.begin(), arguments.end());
  pid_t child = 0;
  const int started = ::posix_spawn(&child, program.c_str(), &actions, nullptr, pointers(all).data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(typed[0]);
  ::close(said[1]);
  std::string line;
  char c = 0;
  while (started == 0 && ::read(said[0], &c, 1) == 1) {
    result.err += c;
    line += c;
    if (c == '\n') {
      const std::string answer = attendant(line, child);
      if (::write(typed[1], answer.data(), answer.size()) < 0) {
        result.err += "(nobody reads what is typed)\n";
      }
      line.clear();
    }
  }
  ::close(typed[1]);
  ::close(said[0]);
  int status = 0;
  if (started != 0 || ::waitpid(child, &status, 0) != child) {
    result.err = std::string("cannot start ") + program + ": " + std::strerror(started);
    return result;
  }
  result.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  result.out = folder.read("out");
  return result;
}

} // namespace straightedge::testing
