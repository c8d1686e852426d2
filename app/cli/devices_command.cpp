#include "app/cli/devices_command.h"

#include "app/cli/messages.h"
#include "core/base/json_writer.h"
#include "devices/bench/device_listing.h"

#include <algorithm>
#include <array>
#include <memory>

namespace straightedge::cli {

namespace {

using devices::ListedDevice;

void textOrNull(JsonWriter& json, std::string_view key, const std::string& text) {
  json.key(key);
  if (text.empty()) {
    json.null();
  } else {
    json.value(text);
  }
}

std::string asJson(const std::vector<ListedDevice>& list) {
  JsonWriter json;
  json.beginList();
  for (const ListedDevice& device : list) {
    json.beginObject();
    textOrNull(json, "vendor_id", device.ids ? devices::hexId(device.ids->vendor) : "");
    textOrNull(json, "product_id", device.ids ? devices::hexId(device.ids->product) : "");
    json.member("serial", device.serial);
    json.member("name", device.name);
    textOrNull(json, "instrument", device.instrument);
    json.openList("roles", true);
    for (const devices::InstrumentRole role : device.roles) {
      json.value(devices::roleWord(role));
    }
    json.endList();
    textOrNull(json, "problem", device.problem);
    textOrNull(json, "remedy", device.remedy);
    textOrNull(json, "path", device.port ? device.port->path : "");
    json.openList("candidates", true);
    for (const std::string& candidate : device.candidates) {
      json.value(candidate);
    }
    json.endList();
    json.endObject();
  }
  json.endList();
  return json.take();
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    text += (text.empty() ? "" : ", ") + word;
  }
  return text;
}

using Row = std::array<std::string, 5>;

Row rowOf(const ListedDevice& device) {
  const std::string ids =
      device.ids ? devices::hexId(device.ids->vendor) + ":" + devices::hexId(device.ids->product) : "-";
  std::string place = device.serial.empty() ? "-" : device.serial;
  if (device.port) {
    place = (device.serial.empty() ? "" : device.serial + " ") + device.port->path;
  }
  std::vector<std::string> roles;
  for (const devices::InstrumentRole role : device.roles) {
    roles.emplace_back(devices::roleWord(role));
  }
  std::string instrument = device.instrument;
  if (instrument.empty() && !device.candidates.empty()) {
    // On a bare serial line everything with such a line may be; the list would say nothing.
    instrument = device.candidates.size() <= 2 ? "perhaps " + joined(device.candidates) : "cannot be told";
  }
  return {ids, place, device.name, instrument.empty() ? "-" : instrument, roles.empty() ? "-" : joined(roles)};
}

/// Characters, not bytes: names of devices may have accents.
std::size_t widthOf(const std::string& text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string asTable(const std::vector<ListedDevice>& list) {
  std::vector<Row> rows{{"USB", "serial, port", "name", "instrument", "can be"}};
  std::array<std::size_t, 5> widths{};
  for (const ListedDevice& device : list) {
    rows.push_back(rowOf(device));
  }
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths.at(i) = std::max(widths.at(i), widthOf(row.at(i)));
    }
  }
  std::string text;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    std::string line;
    for (std::size_t i = 0; i < rows[r].size(); ++i) {
      const std::string& cell = rows[r].at(i);
      line += cell + std::string(widths.at(i) - widthOf(cell) + 2, ' ');
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    if (r > 0 && !list[r - 1].problem.empty()) {
      text += "    cannot be opened: " + list[r - 1].problem + "; " + list[r - 1].remedy + "\n";
    }
  }
  return text;
}

Result<int> tellDevices(bool json) {
  const auto profiles = devices::readProfiles(devices::userProfileFolder());
  for (const Error& problem : profiles.problems) {
    printWarning(problem.message());
  }
  const auto list = devices::listDevices(profiles);
  if (!list) {
    return std::unexpected(list.error());
  }
  if (json) {
    print(asJson(*list));
  } else if (list->empty()) {
    print("Nothing is plugged in: no USB device and no serial port.\n"
          "The simulated bench works without: straightedge-cli capture angle --bench simulated --session FILE\n");
  } else {
    print(asTable(*list));
  }
  return 0;
}

} // namespace

void addDevicesCommand(CLI::App& parent, Work& work) {
  CLI::App* command =
      parent.add_subcommand("devices", "What is plugged in, what it is used for, what keeps it from opening");
  const auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "As a JSON list");
  command->callback([json, &work] { work = [json] { return tellDevices(*json); }; });
}

} // namespace straightedge::cli
