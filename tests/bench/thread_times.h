// Processor time of each thread of this process, by the thread's name.
#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <string>

namespace straightedge::bench {

/// Seconds on a processor so far. Threads of one name are added up; `main` is the name of the first one, whatever it
/// calls itself.
inline std::map<std::string, double> threadTimes() {
  std::map<std::string, double> times;
  const std::string own = std::filesystem::read_symlink("/proc/self").filename().string();
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
    std::string name;
    double runNs = 0.0;
    std::ifstream(task.path() / "comm") >> name;
    std::ifstream(task.path() / "schedstat") >> runNs; // first of three numbers
    times[task.path().filename() == own ? std::string("main") : name] += runNs * 1e-9;
  }
  return times;
}

} // namespace straightedge::bench
