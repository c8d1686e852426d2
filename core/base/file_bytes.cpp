#include "core/base/file_bytes.h"

#include "core/base/input_file.h"

#include <algorithm>
#include <cstddef>

namespace straightedge {

namespace {

constexpr std::size_t pipeBlock = 65536;

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
  auto file = InputFile::open(path);
  if (!file) {
    return std::unexpected(std::move(file.error()));
  }
  std::string bytes;
  std::size_t used = 0;
  std::size_t room = std::min(file->sizeIfKnown() + 1, longestInput); // one more, to see the end without growing
  while (true) {
    if (used == bytes.size()) {
      bytes.resize(used + std::max(room, pipeBlock));
      room = used;
    }
    const auto count = file->read(bytes.data() + used, bytes.size() - used);
    if (!count) {
      return std::unexpected(count.error());
    }
    used += *count;
    if (*count == 0) {
      bytes.resize(used);
      return bytes;
    }
    if (used > longestInput) {
      return fail(ErrorKind::Input, "the input is longer than 2 GiB", "split it into smaller files", inputName(path));
    }
  }
}

} // namespace straightedge
