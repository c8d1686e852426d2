#include "devices/instruments/profile_files.h"

#include "core/base/file_bytes.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace straightedge::devices {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t longestProfile = 1U << 20U;

void add(ProfileSet& set, Profile profile) {
  const auto same = std::ranges::find(set.profiles, profile.id, &Profile::id);
  if (same != set.profiles.end()) {
    *same = std::move(profile);
  } else {
    set.profiles.push_back(std::move(profile));
  }
}

void addFile(ProfileSet& set, const fs::path& path) {
  std::error_code code;
  if (const auto size = fs::file_size(path, code); !code && size > longestProfile) {
    set.problems.push_back(
        {ErrorKind::Input, "the file is too long for a profile", "take it out of the folder", path.string()});
    return;
  }
  const auto text = readFileBytes(path.string());
  if (!text) {
    set.problems.push_back(text.error());
    return;
  }
  auto profile = parseProfile(*text, path.string());
  if (!profile) {
    set.problems.push_back(std::move(profile.error()));
    return;
  }
  add(set, *std::move(profile));
}

} // namespace

ProfileSet readProfiles(const std::string& userFolder) {
  ProfileSet set;
  for (const ShippedProfile& shipped : shippedProfileTexts()) {
    auto profile = parseProfile(shipped.text, std::string(shipped.file));
    if (profile) {
      add(set, *std::move(profile));
    } else {
      set.problems.push_back(std::move(profile.error()));
    }
  }
  std::error_code code;
  if (!userFolder.empty() && fs::is_directory(userFolder, code)) {
    std::vector<fs::path> files;
    for (fs::directory_iterator entry(userFolder, code), end; !code && entry != end; entry.increment(code)) {
      // A copy of the schema may lie beside the profiles, for editors.
      if (entry->path().extension() == ".json" && entry->path().filename() != "instrument.schema.json") {
        files.push_back(entry->path());
      }
    }
    if (code) {
      set.problems.push_back({ErrorKind::Input,
                              "the folder of your instruments cannot be read (" + code.message() + ")",
                              "check its permissions", userFolder});
    }
    std::ranges::sort(files);
    for (const fs::path& file : files) {
      addFile(set, file);
    }
  }
  std::ranges::sort(set.profiles, {}, &Profile::id);
  return set;
}

std::string userProfileFolder() {
  const char* data = std::getenv("XDG_DATA_HOME");
  const char* home = std::getenv("HOME");
  // The specification wants relative paths to be ignored.
  if (data != nullptr && data[0] == '/') {
    return (fs::path(data) / "straightedge" / "instruments").string();
  }
  if (home != nullptr && home[0] != '\0') {
    return (fs::path(home) / ".local" / "share" / "straightedge" / "instruments").string();
  }
  return {};
}

const Profile* findProfile(const ProfileSet& set, std::string_view id) {
  const auto found = std::ranges::find(set.profiles, id, &Profile::id);
  return found == set.profiles.end() ? nullptr : &*found;
}

} // namespace straightedge::devices
