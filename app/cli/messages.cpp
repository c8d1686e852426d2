#include "app/cli/messages.h"

#include "core/base/file_bytes.h"

#include <cstdio>

namespace straightedge::cli {

namespace {

/// One line whatever the text holds (a file name may hold a line break).
std::string oneLine(std::string text) {
  for (char& c : text) {
    c = c == '\n' || c == '\r' ? ' ' : c;
  }
  return text;
}

void printLine(const std::string& text) { std::fputs((oneLine(text) + "\n").c_str(), stderr); }

} // namespace

void printError(const Error& error) { printLine("straightedge-cli: " + error.message()); }

void printNote(std::string_view text) { printLine("straightedge-cli: " + std::string(text)); }

void printWarning(std::string_view text) { printLine("straightedge-cli: warning: " + std::string(text)); }

void print(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stdout); }

Error withPath(Error error, const std::string& fileName, const std::string& path) {
  if (error.where == fileName || error.where.starts_with(fileName + ":")) {
    error.where = inputName(path) + error.where.substr(fileName.size());
  }
  return error;
}

} // namespace straightedge::cli
