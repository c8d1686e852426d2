// JSON text, written in the order of the calls with numbers that read back to the same double.
#pragma once

#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace straightedge {

/// Objects put a key and a value on each line, indented by two; lists begun with compact = true stay on one line.
/// Calls must be balanced. A double that is not finite becomes null: JSON has no word for it.
class JsonWriter {
public:
  void beginObject(bool compact = false) { begin('{', compact); }
  void endObject() { end('}'); }
  void beginList(bool compact = false) { begin('[', compact); }
  void endList() { end(']'); }
  void key(std::string_view name);

  void value(double number);
  void value(std::string_view text);
  void value(const char* text) { value(std::string_view(text)); }
  void value(bool yes) { raw(yes ? "true" : "false"); }
  template <std::integral Integer>
  void value(Integer number) {
    raw(std::to_string(number));
  }
  void null() { raw("null"); }

  template <typename T>
  void member(std::string_view name, const T& content) {
    key(name);
    value(content);
  }
  void openObject(std::string_view name, bool compact = false) {
    key(name);
    beginObject(compact);
  }
  void openList(std::string_view name, bool compact = false) {
    key(name);
    beginList(compact);
  }

  /// The finished text, ended by a newline.
  std::string take();

private:
  struct Level {
    bool compact = false;
    bool empty = true;
  };
  void begin(char bracket, bool compact);
  void end(char bracket);
  void raw(std::string_view text);
  void separate();
  void newLine() { m_text.append(1, '\n').append(2 * m_levels.size(), ' '); }

  std::string m_text;
  std::vector<Level> m_levels;
  bool m_afterKey = false;
};

} // namespace straightedge
