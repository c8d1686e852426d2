#include "core/base/file_bytes.h"

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <fcntl.h>
#include <string_view>
#include <sys/stat.h>
#include <unistd.h>

namespace straightedge {

namespace {

constexpr std::size_t longestInput = std::size_t{2} << 30U;

/// Closes on leaving; standard input stays open.
class ReadOnlyFile {
public:
  explicit ReadOnlyFile(const std::string& path)
      : m_descriptor(path == "-" ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {}
  ~ReadOnlyFile() {
    if (m_descriptor > STDIN_FILENO) {
      ::close(m_descriptor);
    }
  }
  ReadOnlyFile(const ReadOnlyFile&) = delete;
  ReadOnlyFile& operator=(const ReadOnlyFile&) = delete;
  int descriptor() const { return m_descriptor; }

private:
  int m_descriptor;
};

std::unexpected<Error> openFailed(const std::string& path, int code) {
  switch (code) {
  case ENOENT:
  case ENOTDIR:
    return fail(ErrorKind::Input, "the file does not exist", "check the name and the folder", inputName(path));
  case EACCES:
  case EPERM:
    return fail(ErrorKind::Input, "reading the file is not permitted", "ask for read access or copy the file",
                inputName(path));
  default:
    return fail(ErrorKind::Input, std::string("the file cannot be opened: ") + std::strerror(code),
                "check the name and the disk", inputName(path));
  }
}

std::unexpected<Error> readFailed(const std::string& path, int code) {
  if (code == EISDIR) {
    return fail(ErrorKind::Input, "this is a folder, not a file", "name a file inside it", inputName(path));
  }
  return fail(ErrorKind::Input, std::string("reading stopped: ") + std::strerror(code),
              "check the disk or the program that writes into the pipe", inputName(path));
}

} // namespace

std::string inputName(const std::string& path) { return path == "-" ? "standard input" : path; }

std::string inputFileName(const std::string& path) {
  if (path == "-") {
    return inputName(path);
  }
  const auto slash = path.find_last_of('/');
  return slash == std::string::npos ? path : path.substr(slash + 1);
}

Result<std::string> readFileBytes(const std::string& path) {
  const ReadOnlyFile file(path);
  if (file.descriptor() < 0) {
    return openFailed(path, errno);
  }
  std::string bytes;
  struct stat status{};
  if (::fstat(file.descriptor(), &status) == 0 && S_ISREG(status.st_mode) && status.st_size > 0 &&
      static_cast<std::size_t>(status.st_size) <= longestInput) {
    bytes.reserve(static_cast<std::size_t>(status.st_size) + 1);
  }
  std::array<char, 65536> block; // NOLINT(cppcoreguidelines-pro-type-member-init): filled by read()
  while (true) {
    const ssize_t count = ::read(file.descriptor(), block.data(), block.size());
    if (count < 0 && errno == EINTR) {
      continue;
    }
    if (count < 0) {
      return readFailed(path, errno);
    }
    if (count == 0) {
      return bytes;
    }
    bytes.append(block.data(), static_cast<std::size_t>(count));
    if (bytes.size() > longestInput) {
      return fail(ErrorKind::Input, "the input is longer than 2 GiB", "split it into smaller files", inputName(path));
    }
  }
}

} // namespace straightedge
