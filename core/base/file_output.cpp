#include "core/base/file_output.h"

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <memory>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace straightedge {

namespace {

namespace fs = std::filesystem;

std::string outputName(const std::string& path) { return path == "-" ? "standard output" : path; }

std::unexpected<Error> storageError(const std::string& path, int code) {
  const std::string where = outputName(path);
  switch (code) {
  case ENOSPC:
  case EDQUOT:
    return fail(ErrorKind::Storage, "the disk is full", "free some space or write to another folder", where);
  case EFBIG:
    return fail(ErrorKind::Storage, "the file grows beyond the largest size allowed here",
                "raise the limit (ulimit -f) or write to another folder", where);
  case EACCES:
  case EPERM:
    return fail(ErrorKind::Storage, "writing is not permitted", "choose another folder or ask for write access", where);
  case EROFS:
    return fail(ErrorKind::Storage, "the disk is read-only", "write to another folder", where);
  case ENOENT:
    return fail(ErrorKind::Storage, "the folder does not exist", "create it or choose another one", where);
  case ENOTDIR:
    return fail(ErrorKind::Storage, "a part of the path is a file, not a folder", "choose another path", where);
  case EISDIR:
    return fail(ErrorKind::Storage, "there is a folder of this name", "choose another name", where);
  case ENAMETOOLONG:
    return fail(ErrorKind::Storage, "the name is too long for the file system", "choose a shorter name", where);
  default:
    return fail(ErrorKind::Storage, std::string("cannot write: ") + std::strerror(code),
                "check the disk or write to another folder", where);
  }
}

/// The file that a symbolic link stands for, so that the link stays.
std::string followed(const std::string& path) {
  if (!fs::is_symlink(fs::path(path))) {
    return path;
  }
  const std::unique_ptr<char, decltype(&std::free)> real(::realpath(path.c_str(), nullptr), &std::free);
  return real ? std::string(real.get()) : path;
}

std::string temporaryName(const std::string& target) {
  static std::atomic<unsigned> counter{0};
  const fs::path path(target);
  const std::string name = "." + path.filename().string().substr(0, 200) + "." + std::to_string(::getpid()) + "-" +
                           std::to_string(counter++) + ".part";
  return (path.parent_path() / name).string();
}

std::string folderOf(const std::string& target) {
  const std::string parent = fs::path(target).parent_path().string();
  return parent.empty() ? "." : parent;
}

} // namespace

PendingFile::PendingFile(std::string path, std::string target, int descriptor)
    : m_path(std::move(path)), m_target(std::move(target)), m_descriptor(descriptor) {}

PendingFile::PendingFile(PendingFile&& other) noexcept
    : m_path(std::move(other.m_path)), m_target(std::move(other.m_target)), m_temporary(std::move(other.m_temporary)),
      m_descriptor(other.m_descriptor) {
  other.m_descriptor = -1;
  other.m_temporary.clear();
}

PendingFile::~PendingFile() {
  if (m_descriptor > STDERR_FILENO) {
    ::close(m_descriptor);
  }
  if (!m_temporary.empty()) {
    ::unlink(m_temporary.c_str());
  }
}

std::unexpected<Error> PendingFile::failed(int code) const { return storageError(m_path, code); }

Result<PendingFile> PendingFile::create(const std::string& path) {
  if (path == "-") {
    return PendingFile(path, {}, STDOUT_FILENO);
  }
  const std::string target = followed(path);
  struct stat status{};
  constexpr mode_t mode = 0666;
  const bool exists = ::stat(target.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) {
    return storageError(path, EISDIR);
  }
  if (exists && !S_ISREG(status.st_mode)) {
    const int descriptor = ::open(target.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
    return descriptor < 0 ? Result<PendingFile>(storageError(path, errno)) : PendingFile(path, {}, descriptor);
  }
  // A file without a name disappears by itself if the program is killed.
  int descriptor = ::open(folderOf(target).c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, mode);
  std::string temporary;
  if (descriptor < 0 && (errno == EOPNOTSUPP || errno == EISDIR || errno == EINVAL)) {
    temporary = temporaryName(target);
    descriptor = ::open(temporary.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, mode);
  }
  if (descriptor < 0) {
    return storageError(path, errno);
  }
  if (exists) {
    ::fchmod(descriptor, status.st_mode & 07777U); // a replaced file keeps its permissions where that is allowed
  }
  PendingFile file(path, target, descriptor);
  file.m_temporary = std::move(temporary);
  return file;
}

Result<void> PendingFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(m_descriptor, bytes.data(), bytes.size());
    if (count < 0 && errno != EINTR) {
      return failed(errno);
    }
    bytes.remove_prefix(count > 0 ? static_cast<std::size_t>(count) : 0);
  }
  return {};
}

Result<void> PendingFile::giveName() {
  if (m_temporary.empty()) {
    const std::string self = "/proc/self/fd/" + std::to_string(m_descriptor);
    if (::linkat(AT_FDCWD, self.c_str(), AT_FDCWD, m_target.c_str(), AT_SYMLINK_FOLLOW) == 0) {
      return {};
    }
    if (errno != EEXIST) {
      return failed(errno);
    }
    std::string temporary = temporaryName(m_target);
    if (::linkat(AT_FDCWD, self.c_str(), AT_FDCWD, temporary.c_str(), AT_SYMLINK_FOLLOW) != 0) {
      return failed(errno);
    }
    m_temporary = std::move(temporary);
  }
  if (::rename(m_temporary.c_str(), m_target.c_str()) != 0) {
    return failed(errno);
  }
  m_temporary.clear();
  return {};
}

Result<void> PendingFile::commit(Durability durability) {
  if (!m_target.empty()) {
    if (durability == Durability::Synced && ::fsync(m_descriptor) != 0) {
      return failed(errno);
    }
    if (auto named = giveName(); !named) {
      return named;
    }
  }
  if (m_descriptor > STDERR_FILENO) {
    const int descriptor = m_descriptor;
    m_descriptor = -1;
    if (::close(descriptor) != 0 && errno != EINTR) {
      return failed(errno);
    }
  }
  return {};
}

Result<void> writeFileWhole(const std::string& path, std::string_view bytes, Durability durability) {
  auto file = PendingFile::create(path);
  if (!file) {
    return std::unexpected(std::move(file.error()));
  }
  if (auto written = file->write(bytes); !written) {
    return written;
  }
  return file->commit(durability);
}

Result<void> makeFolder(const std::string& path) {
  std::error_code code;
  fs::create_directories(path, code);
  if (!code && fs::is_directory(path, code)) {
    return {};
  }
  if (fs::exists(path)) {
    return fail(ErrorKind::Storage, "there is a file of this name, a folder is needed", "choose another name", path);
  }
  return storageError(path, code ? code.value() : EIO);
}

} // namespace straightedge
