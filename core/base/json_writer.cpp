#include "core/base/json_writer.h"

#include "core/base/number_text.h"

#include <cmath>

namespace straightedge {

namespace {

/// Length of the UTF-8 sequence at the start of `text` (RFC 3629, without overlong forms and surrogates); 0 if it is
/// none.
std::size_t utf8Length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80U) {
    return 1;
  }
  const std::size_t length = lead >= 0xC2U && lead <= 0xDFU   ? 2
                             : (lead & 0xF0U) == 0xE0U        ? 3
                             : lead >= 0xF0U && lead <= 0xF4U ? 4
                                                              : 0;
  if (length == 0 || text.size() < length) {
    return 0;
  }
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) {
      return 0;
    }
  }
  const bool overlong = (lead == 0xE0U && byte(1) < 0xA0U) || (lead == 0xF0U && byte(1) < 0x90U);
  const bool beyond = (lead == 0xEDU && byte(1) > 0x9FU) || (lead == 0xF4U && byte(1) > 0x8FU);
  return overlong || beyond ? 0 : length;
}

/// Bytes that are no UTF-8, as an old file name may hold, become U+FFFD: JSON is UTF-8.
void appendQuoted(std::string& out, std::string_view text) {
  constexpr std::string_view digits = "0123456789abcdef";
  out += '"';
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    const auto byte = static_cast<unsigned char>(c);
    const std::size_t length = utf8Length(text.substr(i));
    if (length != 1) {
      out += length == 0 ? std::string_view("\xEF\xBF\xBD") : text.substr(i, length);
      i += length == 0 ? 1 : length;
      continue;
    }
    ++i;
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (c == '\n') {
      out += "\\n";
    } else if (c == '\t') {
      out += "\\t";
    } else if (byte < 0x20U) {
      out += "\\u00";
      out += digits[byte >> 4U];
      out += digits[byte & 15U];
    } else {
      out += c;
    }
  }
  out += '"';
}

} // namespace

void JsonWriter::separate() {
  if (m_afterKey) {
    m_afterKey = false;
    return;
  }
  if (m_levels.empty()) {
    return;
  }
  Level& level = m_levels.back();
  if (!level.empty) {
    m_text += level.compact ? ", " : ",";
  }
  level.empty = false;
  if (!level.compact) {
    newLine();
  }
}

void JsonWriter::begin(char bracket, bool compact) {
  separate();
  m_text += bracket;
  const bool insideCompact = !m_levels.empty() && m_levels.back().compact;
  m_levels.push_back({compact || insideCompact, true});
}

void JsonWriter::end(char bracket) {
  const Level level = m_levels.back();
  m_levels.pop_back();
  if (!level.compact && !level.empty) {
    newLine();
  }
  m_text += bracket;
}

void JsonWriter::key(std::string_view name) {
  separate();
  appendQuoted(m_text, name);
  m_text += ": ";
  m_afterKey = true;
}

void JsonWriter::raw(std::string_view text) {
  separate();
  m_text += text;
}

void JsonWriter::value(double number) {
  if (std::isfinite(number)) {
    raw(formatDouble(number));
  } else {
    null();
  }
}

void JsonWriter::value(std::string_view text) {
  separate();
  appendQuoted(m_text, text);
}

std::string JsonWriter::take() {
  m_text += '\n';
  return std::move(m_text);
}

} // namespace straightedge
