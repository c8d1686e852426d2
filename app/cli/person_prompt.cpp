#include "app/cli/person_prompt.h"

#include <cerrno>
#include <iostream>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

namespace straightedge::cli {

namespace {

/// Takes one line, or what there is of it.
PersonPrompt::Answer lookForEnter() {
  for (;;) {
    pollfd typed{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
    if (::poll(&typed, 1, 0) <= 0) {
      return PersonPrompt::Answer::NotYet;
    }
    char c = 0;
    const ssize_t got = ::read(STDIN_FILENO, &c, 1);
    if (got < 0 && (errno == EINTR || errno == EAGAIN)) {
      return PersonPrompt::Answer::NotYet;
    }
    if (got <= 0) {
      return PersonPrompt::Answer::NobodyThere;
    }
    if (c == '\n') {
      return PersonPrompt::Answer::Done;
    }
  }
}

} // namespace

PersonPrompt::Answer PersonPrompt::ask(const std::string& instruction) {
  if (m_asked != instruction) {
    m_asked = instruction;
    std::cerr << (m_confirmsAll ? instruction + ": taken as done\n" : "Please " + instruction + ", then press Enter\n")
              << std::flush;
    if (!m_confirmsAll && ::isatty(STDIN_FILENO) != 0) {
      ::tcflush(STDIN_FILENO, TCIFLUSH); // an Enter from before was not meant for this
    }
  }
  const Answer answer = m_confirmsAll ? Answer::Done : lookForEnter();
  if (answer == Answer::Done) {
    m_asked.clear(); // asked for again, it is shown again
  }
  return answer;
}

} // namespace straightedge::cli
