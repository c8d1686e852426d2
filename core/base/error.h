// What went wrong between rooms: one kind (it decides the exit code), one place, one sentence, one remedy.
#pragma once

#include <cstdint>
#include <expected>
#include <string>
#include <utility>

namespace straightedge {

/// Whose fault it is; the command line's exit code follows from it (see exitCode()).
enum class ErrorKind : std::uint8_t {
  Usage,      ///< wrong option, missing argument, value out of range: exit code 2
  Input,      ///< unreadable, malformed, not enough data, not monotonic: exit code 3
  Instrument, ///< not found, access denied, disconnected, time-out, protocol violation: exit code 4
  Storage,    ///< cannot write, disk full, session file damaged: exit code 5
  Cancelled,  ///< the user stopped the work: exit code 130, as a shell reports an interrupt
};

/// A problem for a person: printed as `WHERE: WHAT; REMEDY`.
struct Error {
  ErrorKind kind = ErrorKind::Input;
  std::string what;   ///< what is wrong, in one clause, without a full stop
  std::string remedy; ///< what to do about it, in one clause; may be empty where nothing can be done
  std::string where;  ///< "FILE:LINE", "FILE" or an instrument's name; may be empty

  /// The one line for stderr or a message box, without the program's name.
  std::string message() const;
};

template <typename T>
using Result = std::expected<T, Error>;

inline std::unexpected<Error> fail(ErrorKind kind, std::string what, std::string remedy, std::string where = {}) {
  return std::unexpected(Error{kind, std::move(what), std::move(remedy), std::move(where)});
}

/// Exit code of straightedge-cli for an error of this kind.
int exitCode(ErrorKind kind);

} // namespace straightedge
