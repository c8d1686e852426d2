// Bytes received and not yet taken: what transports without messages keep between two reads.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace straightedge::devices {

/// Long streams are searched once: a search for the same end goes on where the last one stopped.
class ByteBuffer {
public:
  void append(std::string_view bytes) { m_bytes += bytes; }

  /// Everything up to and including `end`; nothing while it has not come.
  std::optional<std::string> takeThrough(std::string_view end) {
    if (m_end != end) {
      m_end = end;
      m_searched = m_taken;
    }
    const std::size_t found = m_bytes.find(end, m_searched);
    if (found == std::string::npos) {
      // The first bytes of `end` may be there already.
      m_searched = m_bytes.size() >= m_taken + end.size() ? m_bytes.size() - end.size() + 1 : m_taken;
      return std::nullopt;
    }
    std::string taken = m_bytes.substr(m_taken, found + end.size() - m_taken);
    m_taken = m_searched = found + end.size();
    forgetTaken();
    return taken;
  }

  std::string takeAll() {
    std::string taken = m_taken == 0 ? std::move(m_bytes) : m_bytes.substr(m_taken);
    clear();
    return taken;
  }

  std::size_t size() const { return m_bytes.size() - m_taken; }
  bool empty() const { return size() == 0; }
  void clear() {
    m_bytes.clear();
    m_taken = m_searched = 0;
  }

private:
  /// Moves the rest to the front now and then, so that taking many short lines out of a long buffer stays linear.
  void forgetTaken() {
    if (m_taken == m_bytes.size() || m_taken > 4096) {
      m_bytes.erase(0, m_taken);
      m_taken = m_searched = 0;
    }
  }

  std::string m_bytes;
  std::string m_end;
  std::size_t m_taken = 0;
  std::size_t m_searched = 0; ///< `m_end` does not begin before this
};

} // namespace straightedge::devices
