#include "devices/transport/dialogue.h"

#include "core/base/file_bytes.h"
#include "core/base/number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace straightedge::devices {

namespace {

constexpr std::string_view firstLine = "straightedge-dialogue 1";
constexpr std::string_view hexDigits = "0123456789ABCDEF";

constexpr std::array<std::pair<DialogueMark, std::string_view>, 8> marks = {{{DialogueMark::Sent, ">"},
                                                                             {DialogueMark::Received, "<"},
                                                                             {DialogueMark::Cleared, "x"},
                                                                             {DialogueMark::Status, "s"},
                                                                             {DialogueMark::SendingFailed, "!>"},
                                                                             {DialogueMark::ReceivingFailed, "!<"},
                                                                             {DialogueMark::ClearingFailed, "!x"},
                                                                             {DialogueMark::StatusFailed, "!s"}}};

constexpr std::array<std::pair<TransportFault, std::string_view>, 9> faults = {
    {{TransportFault::AccessDenied, "access-denied"},
     {TransportFault::Busy, "busy"},
     {TransportFault::Gone, "gone"},
     {TransportFault::TimedOut, "timed-out"},
     {TransportFault::Stalled, "stalled"},
     {TransportFault::Overflow, "overflow"},
     {TransportFault::Protocol, "protocol"},
     {TransportFault::Unsupported, "unsupported"},
     {TransportFault::Failed, "failed"}}};

std::optional<unsigned> hexDigit(char c) {
  if (c >= '0' && c <= '9') {
    return static_cast<unsigned>(c - '0');
  }
  const char upper = static_cast<char>(c & ~0x20);
  if (upper >= 'A' && upper <= 'F') {
    return static_cast<unsigned>(upper - 'A' + 10);
  }
  return std::nullopt;
}

/// One escape sequence at the start of `text`, behind its backslash: the byte and how many characters it took.
std::optional<std::pair<char, std::size_t>> escapeAt(std::string_view text) {
  if (text.empty()) {
    return std::nullopt;
  }
  switch (text[0]) {
  case 'n':
    return std::pair{'\n', 1U};
  case 'r':
    return std::pair{'\r', 1U};
  case 't':
    return std::pair{'\t', 1U};
  case '\\':
    return std::pair{'\\', 1U};
  case 'x': {
    const auto high = text.size() > 2 ? hexDigit(text[1]) : std::nullopt;
    const auto low = text.size() > 2 ? hexDigit(text[2]) : std::nullopt;
    if (high && low) {
      return std::pair{static_cast<char>(*high * 16 + *low), 3U};
    }
    return std::nullopt;
  }
  default:
    return std::nullopt;
  }
}

bool isFailure(DialogueMark mark) {
  return mark == DialogueMark::SendingFailed || mark == DialogueMark::ReceivingFailed ||
         mark == DialogueMark::ClearingFailed || mark == DialogueMark::StatusFailed;
}

/// Everything before the first `separator`, which is taken off `text` together with it.
std::string_view takeThrough(std::string_view& text, std::string_view separator) {
  const std::size_t at = text.find(separator);
  const std::string_view head = text.substr(0, at);
  text.remove_prefix(at == std::string_view::npos ? text.size() : at + separator.size());
  return head;
}

/// `text` without a semicolon of its own: the first one ends the clause.
std::string escapedClause(std::string_view text) {
  std::string clause = escaped(text);
  for (std::size_t at = 0; (at = clause.find(';', at)) != std::string::npos;) {
    clause.replace(at, 1, "\\x3B");
  }
  return clause;
}

std::optional<TransportError> parseFault(std::string_view text) {
  const std::string_view word = takeThrough(text, ": ");
  const auto known = std::ranges::find(faults, word, &std::pair<TransportFault, std::string_view>::second);
  const auto what = unescaped(takeThrough(text, "; "));
  const auto remedy = unescaped(text);
  if (known == faults.end() || !what || !remedy) {
    return std::nullopt;
  }
  return TransportError{known->first, Error{ErrorKind::Instrument, *what, *remedy, {}}};
}

std::optional<DialogueEntry> parseEntry(std::string_view line) {
  const auto time = parseDouble(takeThrough(line, " "));
  const std::string_view word = takeThrough(line, " ");
  const auto mark = std::ranges::find(marks, word, &std::pair<DialogueMark, std::string_view>::second);
  constexpr double longestTimeS = 1e12; // beyond, and for nan, a line could not be written again
  if (!time || !(*time >= 0.0 && *time <= longestTimeS) || mark == marks.end()) {
    return std::nullopt;
  }
  DialogueEntry entry{.timeS = *time, .mark = mark->first, .bytes = {}, .fault = {}, .line = 0};
  if (isFailure(entry.mark)) {
    auto fault = parseFault(line);
    if (!fault) {
      return std::nullopt;
    }
    entry.fault = *std::move(fault);
    return entry;
  }
  auto bytes = unescaped(line);
  const bool wrongLength = bytes && ((entry.mark == DialogueMark::Status && bytes->size() != 1) ||
                                     (entry.mark == DialogueMark::Cleared && !bytes->empty()));
  if (!bytes || wrongLength) {
    return std::nullopt;
  }
  entry.bytes = *std::move(bytes);
  return entry;
}

} // namespace

std::string escaped(std::string_view bytes) {
  std::string text;
  text.reserve(bytes.size());
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const char c = bytes[i];
    const auto byte = static_cast<unsigned char>(c);
    const bool trailingBlank = c == ' ' && i + 1 == bytes.size();
    if (c == '\n' || c == '\r' || c == '\t' || c == '\\') {
      text += '\\';
      text += c == '\n' ? 'n' : c == '\r' ? 'r' : c == '\t' ? 't' : '\\';
    } else if (byte < 0x20U || byte > 0x7EU || trailingBlank) {
      text += "\\x";
      text += hexDigits[byte >> 4U];
      text += hexDigits[byte & 15U];
    } else {
      text += c;
    }
  }
  return text;
}

std::optional<std::string> unescaped(std::string_view text) {
  std::string bytes;
  bytes.reserve(text.size());
  while (!text.empty()) {
    const char c = text.front();
    text.remove_prefix(1);
    if (c != '\\') {
      bytes += c;
      continue;
    }
    const auto escape = escapeAt(text);
    if (!escape) {
      return std::nullopt;
    }
    bytes += escape->first;
    text.remove_prefix(escape->second);
  }
  return bytes;
}

std::string_view markText(DialogueMark mark) {
  return std::ranges::find(marks, mark, &std::pair<DialogueMark, std::string_view>::first)->second;
}

std::string dialogueHeader(const Transport& transport) {
  return std::string(firstLine) + "\ntransport " + escaped(transport.name()) + "\nmessages " +
         (transport.hasMessages() ? "yes" : "no") + "\n";
}

std::string dialogueLine(const DialogueEntry& entry) {
  std::array<char, 64> time{};
  const auto end = std::to_chars(time.data(), time.data() + time.size(), entry.timeS, std::chars_format::fixed, 6);
  std::string line(time.data(), end.ptr);
  line += ' ';
  line += markText(entry.mark);
  if (isFailure(entry.mark)) {
    const auto known =
        std::ranges::find(faults, entry.fault.fault, &std::pair<TransportFault, std::string_view>::first);
    line += ' ';
    line += known->second;
    line += ": " + escapedClause(entry.fault.error.what) + "; " + escaped(entry.fault.error.remedy);
  } else if (entry.mark != DialogueMark::Cleared) {
    line += ' ';
    line += escaped(entry.bytes);
  }
  return line + "\n";
}

Result<Dialogue> parseDialogue(std::string_view text, const std::string& name) {
  constexpr const char* remedy = "record the dialogue anew";
  Dialogue dialogue;
  for (int number = 1; !text.empty(); ++number) {
    std::string_view line = takeThrough(text, "\n");
    if (line.ends_with('\r')) {
      line.remove_suffix(1);
    }
    const std::string where = name + ":" + std::to_string(number);
    if (number == 1) {
      if (line != firstLine) {
        return fail(ErrorKind::Input,
                    "this is no recorded dialogue: it does not begin with '" + std::string(firstLine) + "'",
                    "choose another file", where);
      }
      continue;
    }
    if (line.empty() || line.front() == '#') {
      continue;
    }
    if (line.starts_with("transport ")) {
      dialogue.transportName = unescaped(line.substr(10)).value_or(std::string(line.substr(10)));
      continue;
    }
    if (line == "messages yes" || line == "messages no") {
      dialogue.hasMessages = line == "messages yes";
      continue;
    }
    auto entry = parseEntry(line);
    if (!entry) {
      return fail(ErrorKind::Input, "this is no exchange: seconds, one of > < x s !> !< !x !s, and bytes", remedy,
                  where);
    }
    entry->line = number;
    dialogue.entries.push_back(*std::move(entry));
  }
  if (dialogue.entries.empty()) {
    return fail(ErrorKind::Input, "the recorded dialogue is empty", remedy, name);
  }
  return dialogue;
}

Result<Dialogue> readDialogue(const std::string& path) {
  const auto text = readFileBytes(path);
  if (!text) {
    return std::unexpected(text.error());
  }
  return parseDialogue(*text, inputName(path));
}

} // namespace straightedge::devices
