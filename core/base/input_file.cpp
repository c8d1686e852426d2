#include "core/base/input_file.h"

#include "core/base/file_bytes.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace straightedge {

namespace {

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

Result<InputFile> InputFile::open(const std::string& path) {
  const int descriptor = path == "-" ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) {
    return openFailed(path, errno);
  }
  return InputFile(path, descriptor);
}

InputFile::InputFile(InputFile&& other) noexcept
    : m_path(std::move(other.m_path)), m_descriptor(std::exchange(other.m_descriptor, -1)) {}

InputFile::~InputFile() {
  if (m_descriptor > STDIN_FILENO) {
    ::close(m_descriptor);
  }
}

Result<std::size_t> InputFile::read(char* into, std::size_t most) {
  while (true) {
    const ssize_t count = ::read(m_descriptor, into, most);
    if (count >= 0) {
      return static_cast<std::size_t>(count);
    }
    if (errno != EINTR) {
      return readFailed(m_path, errno);
    }
  }
}

std::size_t InputFile::sizeIfKnown() const {
  struct stat status{};
  const bool known = ::fstat(m_descriptor, &status) == 0 && S_ISREG(status.st_mode) && status.st_size > 0;
  return known ? static_cast<std::size_t>(status.st_size) : 0;
}

bool InputFile::hasBytesReady() const {
  pollfd entry{m_descriptor, POLLIN, 0};
  return ::poll(&entry, 1, 0) != 0; // an error counts as ready: read() tells it
}

} // namespace straightedge
