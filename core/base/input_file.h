// An open input: a file, a pipe or standard input, read in pieces.
#pragma once

#include "core/base/error.h"

#include <cstddef>
#include <string>

namespace straightedge {

/// Closes itself; standard input stays open. One thread. Errors are of kind Input, where = inputName(path).
class InputFile {
public:
  /// `path` or "-". Errors: not there, not permitted, …
  static Result<InputFile> open(const std::string& path);
  InputFile(InputFile&& other) noexcept;
  InputFile& operator=(InputFile&&) = delete;
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;
  ~InputFile();

  /// At most `most` bytes as soon as there are some; 0 at the end. Errors: a folder, a failing disk.
  Result<std::size_t> read(char* into, std::size_t most);

  std::size_t sizeIfKnown() const; ///< of a regular file; 0 of a pipe
  bool hasBytesReady() const;      ///< false: read() would wait for the program at the other end of a pipe

private:
  InputFile(std::string path, int descriptor) : m_path(std::move(path)), m_descriptor(descriptor) {}
  std::string m_path;
  int m_descriptor;
};

} // namespace straightedge
