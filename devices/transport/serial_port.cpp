#include "devices/transport/serial_port.h"

#include "devices/transport/byte_buffer.h"
#include "devices/transport/serial_line.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace straightedge::devices {

namespace {

using Clock = std::chrono::steady_clock;

std::unexpected<TransportError> failed(TransportFault fault, std::string what, std::string remedy, std::string where) {
  return std::unexpected(
      TransportError{fault, Error{ErrorKind::Instrument, std::move(what), std::move(remedy), std::move(where)}});
}

std::unexpected<TransportError> openingFailed(int code, const std::string& path) {
  switch (code) {
  case ENOENT:
  case ENXIO:
  case ENODEV:
    return failed(TransportFault::Gone, "there is no such port", "plug the instrument in or choose another port", path);
  case EACCES:
  case EPERM:
    return failed(TransportFault::AccessDenied, "no permission to open the port",
                  "run: sudo usermod -aG dialout $USER, then log in again", path);
  case EBUSY:
  case EWOULDBLOCK:
    return failed(TransportFault::Busy, "another program has the port open", "close that program", path);
  default:
    return failed(TransportFault::Failed, std::string("the port cannot be opened (") + std::strerror(code) + ")",
                  "plug the instrument out and in again", path);
  }
}

class SerialTransport : public Transport {
public:
  SerialTransport(int descriptor, std::string path) : m_descriptor(descriptor), m_path(std::move(path)) {}
  SerialTransport(const SerialTransport&) = delete;
  SerialTransport& operator=(const SerialTransport&) = delete;
  ~SerialTransport() override { ::close(m_descriptor); } // gives the lock back, too

  std::string name() const override { return m_path; }
  TransportResult<void> write(std::string_view bytes, Milliseconds deadline) override;
  TransportResult<std::string> read(Milliseconds deadline) override;
  TransportResult<std::string> readUntil(std::string_view end, Milliseconds deadline) override;
  TransportResult<void> clear() override;

private:
  TransportResult<void> waitFor(short events, Clock::time_point until, std::string_view doing);
  TransportResult<void> receive(Clock::time_point until);
  std::unexpected<TransportError> gone() const {
    return failed(TransportFault::Gone, "the port is gone", "plug the instrument in again", m_path);
  }
  std::unexpected<TransportError> systemFailed(std::string_view doing, int code) const {
    if (code == EIO || code == ENXIO || code == ENODEV) {
      return gone();
    }
    return failed(TransportFault::Failed, std::string(doing) + " failed (" + std::strerror(code) + ")",
                  "plug the instrument out and in again", m_path);
  }

  int m_descriptor;
  std::string m_path;
  ByteBuffer m_received;
};

TransportResult<void> SerialTransport::waitFor(short events, Clock::time_point until, std::string_view doing) {
  for (;;) {
    const auto left = std::chrono::ceil<Milliseconds>(until - Clock::now()).count();
    pollfd waited{.fd = m_descriptor, .events = events, .revents = 0};
    const int ready = ::poll(&waited, 1, static_cast<int>(std::clamp<std::int64_t>(left, 0, 1'000'000)));
    if (ready < 0 && errno == EINTR) {
      continue;
    }
    if (ready < 0) {
      return systemFailed(doing, errno);
    }
    if (ready == 0) {
      if (Clock::now() < until) {
        continue;
      }
      return failed(TransportFault::TimedOut, "no answer within the time allowed",
                    "check the cable, the instrument's power and the line's settings", m_path);
    }
    if ((waited.revents & events) != 0) {
      return {};
    }
    return gone(); // POLLHUP, POLLERR, POLLNVAL with nothing left to read
  }
}

TransportResult<void> SerialTransport::write(std::string_view bytes, Milliseconds deadline) {
  const auto until = Clock::now() + deadline;
  while (!bytes.empty()) {
    if (auto ready = waitFor(POLLOUT, until, "sending"); !ready) {
      if (ready.error().fault == TransportFault::TimedOut) {
        ready.error().error.what = "the line took no more bytes within the time allowed (" +
                                   std::to_string(bytes.size()) + " are left to send)";
      }
      return ready;
    }
    const ssize_t sent = ::write(m_descriptor, bytes.data(), bytes.size());
    if (sent < 0 && errno != EAGAIN && errno != EINTR) {
      return systemFailed("sending", errno);
    }
    bytes.remove_prefix(sent > 0 ? static_cast<std::size_t>(sent) : 0);
  }
  return {};
}

/// At least one byte more into m_received.
TransportResult<void> SerialTransport::receive(Clock::time_point until) {
  for (;;) {
    if (auto ready = waitFor(POLLIN, until, "receiving"); !ready) {
      return ready;
    }
    std::array<char, 4096> bytes{};
    const ssize_t came = ::read(m_descriptor, bytes.data(), bytes.size());
    if (came > 0) {
      m_received.append({bytes.data(), static_cast<std::size_t>(came)});
      return {};
    }
    if (came == 0) {
      return gone(); // readable and empty: the tty was hung up
    }
    if (errno != EAGAIN && errno != EINTR) {
      return systemFailed("receiving", errno);
    }
  }
}

TransportResult<std::string> SerialTransport::read(Milliseconds deadline) {
  if (m_received.empty()) {
    if (auto came = receive(Clock::now() + deadline); !came) {
      return std::unexpected(std::move(came.error()));
    }
  }
  return m_received.takeAll();
}

TransportResult<std::string> SerialTransport::readUntil(std::string_view end, Milliseconds deadline) {
  const auto until = Clock::now() + deadline;
  for (;;) {
    if (auto taken = m_received.takeThrough(end)) {
      return *std::move(taken);
    }
    if (auto came = receive(until); !came) {
      return std::unexpected(std::move(came.error()));
    }
  }
}

TransportResult<void> SerialTransport::clear() {
  m_received.clear();
  if (!emptyLine(m_descriptor)) {
    return systemFailed("emptying the line", errno);
  }
  return {};
}

} // namespace

TransportResult<std::unique_ptr<Transport>> openSerialPort(const std::string& path, const SerialSettings& settings) {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) {
    return openingFailed(errno, path);
  }
  auto port = std::make_unique<SerialTransport>(descriptor, path);
  if (::isatty(descriptor) == 0) {
    return failed(TransportFault::Unsupported, "this is no serial port", "choose another port", path);
  }
  // TIOCEXCL refuses later openings by others, but not by root; the lock does, among programs that ask for it.
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    return openingFailed(EBUSY, path);
  }
  static_cast<void>(::ioctl(descriptor, TIOCEXCL)); // a line that cannot be closed to others works all the same
  if (const auto refused = setUpLine(descriptor, settings)) {
    return failed(TransportFault::Unsupported, "the port refuses " + *refused, "choose other settings of the line",
                  path);
  }
  emptyLine(descriptor);
  return port;
}

} // namespace straightedge::devices
