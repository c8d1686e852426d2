#include "app/cli/dialogue_folder.h"

#include "app/cli/messages.h"
#include "core/base/file_output.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iostream>

namespace straightedge::cli {

namespace {

/// Letters, digits and a few marks: a name on every file system.
std::string asFileName(std::string text) {
  std::ranges::replace_if(
      text, [](unsigned char c) { return std::isalnum(c) == 0 && c != '-' && c != '_' && c != '.'; }, '-');
  return text;
}

} // namespace

Result<void> DialogueFolder::make() const { return m_path.empty() ? Result<void>{} : makeFolder(m_path); }

devices::BenchDialogueListener DialogueFolder::listener() {
  if (m_path.empty()) {
    return {};
  }
  return [this](const devices::BenchExchange& heard) { hear(heard); };
}

std::string DialogueFolder::freeName(const devices::BenchInstrument& instrument) const {
  const std::string name = m_path + "/" + asFileName(instrument.instrument) + "-" +
                           asFileName(instrument.serial.empty() ? instrument.port : instrument.serial);
  std::string free = name + ".dialogue";
  std::error_code ignored;
  for (int i = 2; std::filesystem::exists(free, ignored); ++i) {
    free = name + "-" + std::to_string(i) + ".dialogue";
  }
  return free;
}

void DialogueFolder::hear(const devices::BenchExchange& heard) {
  const Key key{heard.instrument, heard.connection};
  auto file = m_files.find(key);
  if (file == m_files.end()) {
    file = m_files.emplace(key, devices::DialogueFile::create(freeName(heard.wanted), heard.transport)).first;
  }
  if (file->second) {
    file->second->add(heard.entry);
  }
}

void DialogueFolder::tell() const {
  if (m_path.empty()) {
    return;
  }
  std::cerr << "dialogues with the instruments: " << m_files.size() << (m_files.size() == 1 ? " file" : " files")
            << " in " << m_path << "; attach them to a bug report\n";
  for (const auto& [key, file] : m_files) {
    if (!file) {
      printWarning(file.error().message());
    } else if (file->problem()) {
      printWarning(file->problem()->message());
    }
  }
}

} // namespace straightedge::cli
