// The far end of a serial line: a pseudo terminal whose near end the code under test opens by its path.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <fcntl.h>
#include <poll.h>
#include <string>
#include <string_view>
#include <unistd.h>

namespace straightedge::devices {

class PseudoTerminal {
public:
  PseudoTerminal() : m_far(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)) {
    EXPECT_GE(m_far, 0);
    EXPECT_EQ(::grantpt(m_far), 0);
    EXPECT_EQ(::unlockpt(m_far), 0);
    std::array<char, 128> name{};
    EXPECT_EQ(::ptsname_r(m_far, name.data(), name.size()), 0);
    m_path = name.data();
  }
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;
  ~PseudoTerminal() { hangUp(); }

  const std::string& path() const { return m_path; }

  void send(std::string_view bytes) const {
    ASSERT_EQ(::write(m_far, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
  }

  /// The next `count` bytes that the near end sent; fewer if they do not come within 5 s.
  std::string receive(std::size_t count) const {
    std::string got;
    while (got.size() < count) {
      pollfd waited{.fd = m_far, .events = POLLIN, .revents = 0};
      std::array<char, 256> bytes{};
      if (::poll(&waited, 1, 5000) <= 0) {
        break;
      }
      const ssize_t came = ::read(m_far, bytes.data(), std::min(bytes.size(), count - got.size()));
      if (came <= 0) {
        break;
      }
      got.append(bytes.data(), static_cast<std::size_t>(came));
    }
    return got;
  }

  int descriptor() const { return m_far; }

  void hangUp() {
    if (m_far >= 0) {
      ::close(m_far);
    }
    m_far = -1;
  }

private:
  int m_far;
  std::string m_path;
};

} // namespace straightedge::devices
