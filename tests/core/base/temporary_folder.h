// A folder of its own for each test, removed at the end.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace straightedge::testing {

class TemporaryFolder {
public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "straightedge-test-XXXXXX").string();
    m_path = ::mkdtemp(name.data()) == nullptr ? std::string() : name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(m_path, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string file(const std::string& name) const { return m_path + "/" + name; }
  const std::string& path() const { return m_path; }

  std::string write(const std::string& name, std::string_view bytes) const {
    std::ofstream(file(name), std::ios::binary) << bytes;
    return file(name);
  }
  std::string read(const std::string& name) const {
    std::ifstream in(file(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  /// Names of all entries, hidden ones too, sorted and joined by blanks.
  std::string listing(const std::string& folder = ".") const;

private:
  std::string m_path;
};

inline std::string TemporaryFolder::listing(const std::string& folder) const {
  std::string names;
  std::vector<std::string> sorted;
  for (const auto& entry : std::filesystem::directory_iterator(file(folder))) {
    sorted.push_back(entry.path().filename().string());
  }
  std::sort(sorted.begin(), sorted.end());
  for (const std::string& name : sorted) {
    names += (names.empty() ? "" : " ") + name;
  }
  return names;
}

} // namespace straightedge::testing
