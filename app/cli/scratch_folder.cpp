#include "app/cli/scratch_folder.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

namespace straightedge::cli {

namespace fs = std::filesystem;

Result<ScratchFolder> ScratchFolder::create() {
  std::error_code code;
  const fs::path parent = fs::temp_directory_path(code);
  std::string name = (parent / "straightedge-XXXXXX").string();
  if (code || ::mkdtemp(name.data()) == nullptr) {
    return fail(ErrorKind::Storage,
                std::string("no temporary folder can be made: ") + (code ? code.message() : std::strerror(errno)),
                "set TMPDIR to a folder that may be written", parent.string());
  }
  return ScratchFolder(std::move(name));
}

ScratchFolder::ScratchFolder(ScratchFolder&& other) noexcept : m_path(std::exchange(other.m_path, {})) {}

ScratchFolder::~ScratchFolder() {
  if (!m_path.empty()) {
    std::error_code ignored;
    fs::remove_all(m_path, ignored);
  }
}

} // namespace straightedge::cli
