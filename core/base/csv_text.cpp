#include "core/base/csv_text.h"

#include <algorithm>

namespace straightedge {

namespace {

bool startsWithWideMark(std::string_view bytes) {
  return bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF") ||
         bytes.starts_with(std::string_view("\0\0\xFE\xFF", 4));
}

/// UTF-16 without a mark: of plain letters and digits every other byte is zero.
bool looksLikeWideText(std::string_view bytes) {
  const auto head = bytes.substr(0, 64);
  if (head.size() < 8) {
    return false;
  }
  std::size_t evenZeros = 0;
  std::size_t oddZeros = 0;
  for (std::size_t i = 0; i < head.size(); ++i) {
    if (head[i] == '\0') {
      ++(i % 2 == 0 ? evenZeros : oddZeros);
    }
  }
  const std::size_t half = head.size() / 2;
  return (evenZeros == 0 && oddZeros >= half - 1) || (oddZeros == 0 && evenZeros >= half - 1);
}

bool isControl(char c) { // no jumps: looked at many at a time
  const auto byte = static_cast<unsigned char>(c);
  return ((byte < 0x20U) & (byte != '\t') & (byte != '\r') & (byte != '\n') & (byte != '\f')) | (byte == 0x7FU);
}

std::string at(const std::string& name, std::string_view bytes, std::size_t position) {
  const auto lines = std::count(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(position), '\n');
  return name + ":" + std::to_string(lines + 1);
}

} // namespace

bool hasControlBytes(std::string_view bytes) {
  // All bytes of a piece are looked at, many at a time, which is quicker than to stop at the first.
  constexpr std::size_t piece = 4096;
  for (; !bytes.empty(); bytes.remove_prefix(std::min(piece, bytes.size()))) {
    unsigned found = 0;
    for (const char c : bytes.substr(0, piece)) {
      found |= isControl(c) ? 1U : 0U;
    }
    if (found != 0) {
      return true;
    }
  }
  return false;
}

std::size_t byteOrderMarkLength(std::string_view bytes) { return bytes.starts_with("\xEF\xBB\xBF") ? 3 : 0; }

Result<void> checkCsvText(std::string_view bytes, const std::string& name) {
  if (bytes.empty()) {
    return fail(ErrorKind::Input, "the file is empty", "record or export the data again", name);
  }
  if (startsWithWideMark(bytes) || looksLikeWideText(bytes)) {
    return fail(ErrorKind::Input, "the text is UTF-16 or UTF-32",
                "save the file as UTF-8 (in a spreadsheet: CSV UTF-8)", name);
  }
  if (bytes.starts_with("PK\x03\x04") || bytes.starts_with("\xD0\xCF\x11\xE0")) {
    return fail(ErrorKind::Input, "this is a spreadsheet or an archive, not CSV text", "export the table as CSV", name);
  }
  if (hasControlBytes(bytes)) {
    const auto control = std::ranges::find_if(bytes, isControl);
    const auto position = static_cast<std::size_t>(control - bytes.begin());
    constexpr std::string_view digits = "0123456789abcdef";
    const auto byte = static_cast<unsigned char>(*control);
    return fail(ErrorKind::Input,
                std::string("the file is not text: it holds the byte 0x") + digits[byte >> 4U] + digits[byte & 15U],
                "name a CSV file", at(name, bytes, position));
  }
  return {};
}

Result<std::string> csvText(std::string bytes, const std::string& name) {
  if (auto checked = checkCsvText(bytes, name); !checked) {
    return std::unexpected(std::move(checked.error()));
  }
  bytes.erase(0, byteOrderMarkLength(bytes));
  if (bytes.find('\n') == std::string::npos) {
    std::ranges::replace(bytes, '\r', '\n');
  }
  return bytes;
}

} // namespace straightedge
