// Files that only another program needs to see: a folder that disappears again.
#pragma once

#include "core/base/error.h"

#include <string>

namespace straightedge::cli {

class ScratchFolder {
public:
  /// Errors (Storage): no folder can be made where temporary files go.
  static Result<ScratchFolder> create();
  ScratchFolder(ScratchFolder&& other) noexcept;
  ScratchFolder& operator=(ScratchFolder&&) = delete;
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder();

  std::string file(const std::string& name) const { return m_path + "/" + name; }

private:
  explicit ScratchFolder(std::string path) : m_path(std::move(path)) {}
  std::string m_path;
};

} // namespace straightedge::cli
