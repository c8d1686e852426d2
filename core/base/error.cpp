#include "core/base/error.h"

namespace straightedge {

std::string Error::message() const {
  std::string text = where.empty() ? what : where + ": " + what;
  if (!remedy.empty()) {
    text += "; " + remedy;
  }
  return text;
}

int exitCode(ErrorKind kind) {
  switch (kind) {
  case ErrorKind::Usage:
    return 2;
  case ErrorKind::Input:
    return 3;
  case ErrorKind::Instrument:
    return 4;
  case ErrorKind::Storage:
    return 5;
  case ErrorKind::Cancelled:
    return 130;
  }
  return 3;
}

} // namespace straightedge
