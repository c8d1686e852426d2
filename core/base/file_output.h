// Files written whole: under a temporary name in the same folder, then renamed. Nothing half-written is left behind.
#pragma once

#include "core/base/error.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace straightedge {

/// Whether a finished file must survive a power cut the moment it is reported as written.
enum class Durability : std::uint8_t {
  Synced, ///< flushed to the disk before it gets its name
  Cached, ///< left to the operating system: for thousands of files at once
};

/// A file under way. It gets its name in commit(); until then, and if the program dies, the old file stays.
/// "-" is standard output; what is no regular file (a device, a pipe) is written to directly. One thread.
/// All errors are of kind Storage (where = path): no such folder, not permitted, disk full, …
class PendingFile {
public:
  static Result<PendingFile> create(const std::string& path);
  PendingFile(PendingFile&& other) noexcept;
  PendingFile& operator=(PendingFile&&) = delete;
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;
  ~PendingFile(); ///< without commit() nothing remains

  Result<void> write(std::string_view bytes);
  Result<void> commit(Durability durability = Durability::Synced);

private:
  PendingFile(std::string path, std::string target, int descriptor);
  Result<void> giveName();
  std::unexpected<Error> failed(int code) const;

  std::string m_path;      ///< as given, for messages
  std::string m_target;    ///< where the file is to be; empty: written to directly
  std::string m_temporary; ///< name until commit(); empty: the file has none yet
  int m_descriptor;
};

/// The whole of `bytes` as the file at `path` ("-": standard output).
Result<void> writeFileWhole(const std::string& path, std::string_view bytes,
                            Durability durability = Durability::Synced);

/// Makes `path` a folder, with its parents. Errors (Storage): not permitted, a file of that name, …
Result<void> makeFolder(const std::string& path);

} // namespace straightedge
