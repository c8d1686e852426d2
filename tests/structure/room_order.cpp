#include "tests/structure/room_order.h"

#include <algorithm>
#include <array>
#include <optional>
#include <sstream>

namespace straightedge::structure {

namespace {

/// A room may include itself and what it lists; nothing else of ours. A room without an entry is refused.
struct Room {
  std::string_view folder;
  std::vector<std::string_view> mayInclude;
};

const std::vector<Room>& rooms() {
  static const std::vector<Room> all = {
      {"core/base", {}},
      {"core/numerics", {"core/base"}},
      {"core/session", {"core/base"}},
      {"core/angle", {"core/base", "core/numerics", "core/session"}},
      {"core/field", {"core/base", "core/numerics", "core/session"}},
      {"core/export", {"core/base", "core/numerics", "core/angle", "core/field", "core/session"}},
      {"devices/usb", {"core/base"}},
      {"devices/transport", {"core/base", "devices/usb"}},
      {"devices/instruments", {"core/base", "devices/transport"}},
      {"devices/bench", {"core/base", "devices/usb", "devices/transport", "devices/instruments", "devices/simulated"}},
      {"devices/simulated", {"core/base", "core/numerics", "core/field", "devices/instruments"}},
      {"devices/capture", {"core/base", "core/field", "core/session", "devices/instruments", "devices/simulated"}},
      {"app/cli", {"core/", "devices/"}},
      {"app/gui/plots", {"core/base"}},
      {"app/gui/jobs", {"core/base"}},
      {"app/gui/figures", {"core/", "app/gui/plots"}},
      {"app/gui/document", {"core/", "devices/", "app/gui/jobs"}},
      {"app/gui/bench", {"core/base", "devices/", "app/gui/jobs"}},
      {"app/gui/steps",
       {"core/", "devices/", "app/gui/jobs", "app/gui/document", "app/gui/bench", "app/gui/plots", "app/gui/figures"}},
      {"app/gui/field_steps",
       {"core/", "devices/", "app/gui/jobs", "app/gui/document", "app/gui/bench", "app/gui/plots", "app/gui/figures",
        "app/gui/steps"}},
      {"app/gui/shell",
       {"core/", "devices/", "app/gui/jobs", "app/gui/document", "app/gui/plots", "app/gui/figures", "app/gui/steps",
        "app/gui/field_steps"}},
      {"app/gui",
       {"core/", "devices/", "app/gui/shell", "app/gui/figures", "app/gui/document", "app/gui/jobs", "app/gui/steps"}},
  };
  return all;
}

const Room* roomOf(std::string_view path) {
  const Room* best = nullptr;
  for (const Room& room : rooms()) {
    if (path.starts_with(room.folder) && path.size() > room.folder.size() && path[room.folder.size()] == '/' &&
        (best == nullptr || room.folder.size() > best->folder.size())) {
      best = &room;
    }
  }
  return best;
}

struct Include {
  std::string name;
  bool angled = false;
};

std::optional<Include> includeIn(std::string_view line) {
  const auto start = line.find_first_not_of(" \t");
  if (start == std::string_view::npos || line[start] != '#') {
    return std::nullopt;
  }
  const auto word = line.find("include", start);
  const auto open = line.find_first_of("\"<", start);
  if (word == std::string_view::npos || open == std::string_view::npos) {
    return std::nullopt;
  }
  const bool angled = line[open] == '<';
  const auto close = line.find(angled ? '>' : '"', open + 1);
  if (close == std::string_view::npos) {
    return std::nullopt;
  }
  return Include{std::string(line.substr(open + 1, close - open - 1)), angled};
}

bool isQt(std::string_view name) {
  return name.size() > 1 && name[0] == 'Q' && (name[1] == 't' || std::isupper(name[1]) != 0);
}

std::optional<std::string> thirdPartyRule(std::string_view path, std::string_view name) {
  const bool gui = path.starts_with("app/gui/");
  if (isQt(name) && !gui) {
    return "only app/gui may know Qt";
  }
  if (name.starts_with("vtk") && !path.starts_with("app/gui/plots/")) {
    return "only app/gui/plots may know VTK";
  }
  if ((name.starts_with("EGL/") || name.starts_with("GL/")) && !path.starts_with("app/gui/plots/")) {
    return "only app/gui/plots may know OpenGL";
  }
  if (name.starts_with("libusb") && !path.starts_with("devices/usb/")) {
    return "only devices/usb may include libusb";
  }
  if (name == "libserialport.h" && !path.starts_with("devices/transport/")) {
    return "only devices/transport may include libserialport";
  }
  if (name == "sqlite3.h" && !path.starts_with("core/session/")) {
    return "only core/session may know SQLite";
  }
  return std::nullopt;
}

} // namespace

std::vector<Violation> violationsIn(std::string_view path, std::string_view text) {
  std::vector<Violation> found;
  const Room* room = roomOf(path);
  if (room == nullptr) {
    found.push_back(
        {std::string(path), "", "this folder is in no room: add it to the map in CONTRIBUTING.md and here"});
    return found;
  }
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    const auto include = includeIn(line);
    if (!include) {
      continue;
    }
    if (include->angled) {
      if (const auto rule = thirdPartyRule(path, include->name)) {
        found.push_back({std::string(path), include->name, *rule});
      }
      continue;
    }
    const Room* target = roomOf(include->name);
    const bool ours = include->name.starts_with("core/") || include->name.starts_with("devices/") ||
                      include->name.starts_with("app/") || include->name.starts_with("tests/");
    if (!ours) {
      if (!include->name.ends_with(".moc")) {
        found.push_back({std::string(path), include->name, "our own includes are spelled from the root"});
      }
      continue;
    }
    if (target == room) {
      continue;
    }
    const bool allowed = std::ranges::any_of(room->mayInclude, [&](std::string_view folder) {
      return folder.ends_with('/') ? include->name.starts_with(folder) : target != nullptr && target->folder == folder;
    });
    if (!allowed) {
      found.push_back({std::string(path), include->name,
                       "room " + std::string(room->folder) + " may not know " +
                           (target != nullptr ? std::string(target->folder) : std::string("that folder"))});
    }
  }
  return found;
}

} // namespace straightedge::structure
