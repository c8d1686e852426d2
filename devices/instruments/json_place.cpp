#include "devices/instruments/json_place.h"

#include <algorithm>

namespace straightedge::devices {

namespace {

/// Walks over a text that is known to be JSON; stops at its end whatever it is.
class Walker {
public:
  explicit Walker(std::string_view text) : m_text(text) {}

  std::size_t position() const { return m_at; }
  bool done() const { return m_at >= m_text.size(); }
  char peek() const { return done() ? '\0' : m_text[m_at]; }

  void skipBlanks() { m_at = std::min(m_text.find_first_not_of(" \t\r\n", m_at), m_text.size()); }

  /// The string that begins here, without its quotes, escapes left as they are.
  std::string_view string() {
    const std::size_t begin = ++m_at;
    while (!done() && m_text[m_at] != '"') {
      m_at += m_text[m_at] == '\\' ? 2U : 1U;
    }
    const std::size_t end = std::min(m_at, m_text.size());
    ++m_at;
    return m_text.substr(begin, end - begin);
  }

  /// Over the value that begins here, however deep.
  void skipValue() {
    int depth = 0;
    while (!done()) {
      const char c = peek();
      if (c == '"') {
        string();
      } else if (c == '{' || c == '[') {
        ++depth;
        ++m_at;
      } else if (c == '}' || c == ']') {
        if (depth == 0) {
          return; // of the container around it
        }
        --depth;
        ++m_at;
      } else if (depth == 0 && (c == ',' || c == ':')) {
        return;
      } else {
        ++m_at;
        continue;
      }
      if (depth == 0) {
        return;
      }
    }
  }

  void next() { ++m_at; }

private:
  std::string_view m_text;
  std::size_t m_at = 0;
};

/// From a container's first character to its member `key` or item number `key`; false if there is none.
bool enter(Walker& walker, std::string_view key) {
  const char open = walker.peek();
  if (open != '{' && open != '[') {
    return false;
  }
  walker.next();
  for (std::size_t index = 0; !walker.done(); ++index) {
    walker.skipBlanks();
    if (walker.peek() == '}' || walker.peek() == ']') {
      return false;
    }
    bool found = open == '[' && std::to_string(index) == key;
    if (open == '{') {
      if (walker.peek() != '"') {
        return false;
      }
      found = walker.string() == key;
      walker.skipBlanks();
      walker.next(); // the colon
      walker.skipBlanks();
    }
    if (found) {
      return true;
    }
    walker.skipValue();
    walker.skipBlanks();
    if (walker.peek() != ',') {
      return false;
    }
    walker.next();
  }
  return false;
}

} // namespace

int lineInJson(std::string_view text, std::span<const std::string> path) {
  Walker walker(text);
  walker.skipBlanks();
  std::size_t place = walker.position();
  for (const std::string& key : path) {
    if (!enter(walker, key)) {
      break;
    }
    place = walker.position();
  }
  const auto before = text.substr(0, std::min(place, text.size()));
  return static_cast<int>(std::ranges::count(before, '\n')) + 1;
}

} // namespace straightedge::devices
