#include "app/cli/batch_inputs.h"

#include "core/base/csv_text.h"
#include "core/base/file_bytes.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <sstream>

namespace straightedge::cli {

namespace {

namespace fs = std::filesystem;

/// A sweep as CSV, or a session with a captured one.
bool holdsASweep(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
  return extension == ".csv" || extension == ".sedge";
}

Result<std::vector<std::string>> filesOf(const std::string& folder, const std::string& out) {
  std::error_code code;
  std::error_code ignored;
  const bool intoItself = fs::equivalent(folder, out, ignored);
  std::vector<std::string> paths;
  for (fs::directory_iterator entry(folder, code), end; !code && entry != end; entry.increment(code)) {
    const fs::path& path = entry->path();
    const bool ownSummary = intoItself && path.filename() == "summary.csv";
    if (holdsASweep(path) && !ownSummary && !entry->is_directory(ignored)) {
      paths.push_back(path.string());
    }
  }
  if (code) {
    return fail(ErrorKind::Input, "the folder cannot be read: " + code.message(), "ask for access", folder);
  }
  std::sort(paths.begin(), paths.end());
  if (paths.empty()) {
    return fail(ErrorKind::Input, "the folder holds no *.csv and no *.sedge", "name the folder with the sweeps",
                folder);
  }
  return paths;
}

Result<std::vector<std::string>> pathsInList(const std::string& list) {
  auto bytes = readFileBytes(list);
  if (!bytes) {
    return std::unexpected(std::move(bytes.error()));
  }
  const auto text = csvText(std::move(*bytes), inputName(list));
  if (!text) {
    return std::unexpected(text.error());
  }
  const fs::path folder = list == "-" ? fs::path() : fs::path(list).parent_path();
  std::vector<std::string> paths;
  std::istringstream lines(*text);
  for (std::string line; std::getline(lines, line);) {
    line.erase(line.find_last_not_of(" \t\r") + 1);
    line.erase(0, line.find_first_not_of(" \t"));
    if (line.empty() || line.front() == '#') {
      continue;
    }
    std::error_code ignored;
    const bool fromList = !fs::exists(line, ignored) && fs::exists(folder / line, ignored);
    paths.push_back(fromList ? (folder / line).string() : line);
  }
  if (paths.empty()) {
    return fail(ErrorKind::Input, "the list names no files", "write a path in each line", inputName(list));
  }
  return paths;
}

BatchInputs named(const std::vector<std::string>& paths) {
  BatchInputs inputs;
  std::set<std::string> taken;
  std::set<std::string> stems;
  for (const std::string& path : paths) { // a later "x-2.csv" keeps its name
    stems.insert(fs::path(path).stem().string());
  }
  for (const std::string& path : paths) {
    const std::string stem = fs::path(path).stem().string();
    std::string name = stem;
    for (int number = 2; taken.contains(name) || (name != stem && stems.contains(name)); ++number) {
      name = stem + "-" + std::to_string(number);
    }
    taken.insert(name);
    if (name != stem) {
      inputs.renamed.push_back("another input is called " + stem + ": the result of " + path + " is " + name + ".json");
    }
    inputs.list.push_back({path, name + ".json"});
  }
  return inputs;
}

} // namespace

Result<BatchInputs> findBatchInputs(const std::string& source, const std::string& out) {
  std::error_code ignored;
  const auto paths = source != "-" && fs::is_directory(source, ignored) ? filesOf(source, out) : pathsInList(source);
  if (!paths) {
    return std::unexpected(paths.error());
  }
  return named(*paths);
}

} // namespace straightedge::cli
