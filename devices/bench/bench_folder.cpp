#include "devices/bench/bench_folder.h"

#include "devices/bench/saved_bench.h"

#include <algorithm>
#include <filesystem>

namespace straightedge::devices {

std::vector<std::string> savedBenchNames() {
  std::vector<std::string> names;
  std::error_code problem;
  const std::filesystem::directory_iterator none;
  for (std::filesystem::directory_iterator file(userBenchFolder(), problem); !problem && file != none;
       file.increment(problem)) {
    if (file->path().extension() == ".json") {
      names.push_back(file->path().stem().string());
    }
  }
  std::ranges::sort(names);
  return names;
}

Result<void> deleteBench(const std::string& name) {
  const std::string file = benchFile(name);
  std::error_code problem;
  if (!std::filesystem::remove(file, problem) && !problem) {
    return fail(ErrorKind::Instrument, "there is no bench named '" + name + "'", "choose one of the list", file);
  }
  if (problem) {
    return fail(ErrorKind::Storage, "the bench cannot be deleted (" + problem.message() + ")",
                "see to whom the folder belongs", file);
  }
  return {};
}

} // namespace straightedge::devices
