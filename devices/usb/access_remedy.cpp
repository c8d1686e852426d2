#include "devices/usb/access_remedy.h"

#include <algorithm>
#include <string_view>
#include <system_error>

namespace straightedge::devices {

namespace {

namespace fs = std::filesystem;

/// As a shell takes it for one word.
std::string shellWord(const std::string& text) {
  constexpr std::string_view plain = "/._-+@%";
  const bool isPlain = std::ranges::all_of(text, [plain](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || plain.contains(c);
  });
  if (isPlain) {
    return text;
  }
  std::string word = "'";
  for (const char c : text) {
    word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return word + "'";
}

} // namespace

std::string accessRemedy(const fs::path& program) {
  const fs::path rules = fs::path("installer") / "linux" / "70-straightedge.rules";
  const fs::path installer = fs::path("installer") / "run";
  for (fs::path folder = program.parent_path(); folder.has_relative_path(); folder = folder.parent_path()) {
    std::error_code ignored;
    if (fs::is_regular_file(folder / rules, ignored) && fs::is_regular_file(folder / installer, ignored)) {
      return "run: " + shellWord((folder / installer).string()) + " --udev, then plug the device in again";
    }
  }
  return "copy " + rules.string() +
         " of Straightedge's sources into /etc/udev/rules.d as root, then restart udev and plug the device in again";
}

const std::string& accessRemedy() {
  static const std::string ofThisProgram = [] {
    std::error_code ignored;
    return accessRemedy(fs::read_symlink("/proc/self/exe", ignored));
  }();
  return ofThisProgram;
}

} // namespace straightedge::devices
