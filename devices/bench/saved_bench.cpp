#include "devices/bench/saved_bench.h"

#include "core/base/file_bytes.h"
#include "core/base/file_output.h"
#include "core/base/json_writer.h"
#include "devices/instruments/profile_json.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>

namespace straightedge::devices {

namespace {

constexpr const char* whereDescribed = "see the section on benches in README.md";
constexpr int mostInstruments = 16;

std::vector<InstrumentRole> benchRoles(ProfileJson& json, const ProfileNode& node, std::set<InstrumentRole>& taken) {
  std::vector<InstrumentRole> roles;
  for (const ProfileNode& item : json.items(node, "roles")) {
    const std::string word = json.asText(item);
    const auto role = roleFromWord(word);
    if (!role) {
      json.blame(item, "is '" + word + "' and no role",
                 "use angle-sensor, angle-reference, field-probe, field-reference, resistance, temperature or "
                 "chamber-temperature");
    } else if (!taken.insert(*role).second) {
      json.blame(item, "is the role " + word + " a second time", "give each role to one instrument");
    } else {
      roles.push_back(*role);
    }
  }
  if (roles.empty()) {
    json.blame(node.member("roles"), "names no role", whereDescribed);
  }
  return roles;
}

SettingValues benchSettings(ProfileJson& json, const ProfileNode& node) {
  SettingValues values;
  if (!node) {
    return values;
  }
  if (!node.value->is_object()) {
    json.blame(node, "is no JSON object", whereDescribed);
    return values;
  }
  for (const auto& [key, value] : node.value->items()) {
    // Numbers need no quotes; their text is what was written.
    values[key] = value.is_number() ? value.dump() : json.asText(node.member(key));
  }
  return values;
}

BenchInstrument benchInstrument(ProfileJson& json, const ProfileNode& node, std::set<InstrumentRole>& taken) {
  BenchInstrument one;
  if (!json.object(node, {"instrument", "roles", "serial", "port", "settings", "latency_s", "baud"})) {
    return one;
  }
  one.instrument = json.requiredText(node, "instrument");
  one.roles = benchRoles(json, node, taken);
  one.serial = json.text(node, "serial", "");
  one.port = json.text(node, "port", "");
  if (one.serial.empty() == one.port.empty()) {
    json.blame(node, one.serial.empty() ? "has neither serial nor port" : "has both serial and port",
               "give the serial number that straightedge-cli devices prints, or the port where there is none");
  }
  one.settings = benchSettings(json, node.member("settings"));
  one.latencyS = json.number(node, "latency_s", 0.0, 0.0, 60.0);
  if (node.member("baud")) {
    one.baud = json.integer(node, "baud", 115200, 50, 12'000'000);
  }
  return one;
}

PairingRule benchPairing(ProfileJson& json, const ProfileNode& node) {
  PairingRule rule;
  if (!node || !json.object(node, {"rule", "max_age_s"})) {
    return rule;
  }
  const std::string word = json.requiredText(node, "rule");
  const auto kind = pairingFromWord(word);
  if (!kind) {
    json.blame(node.member("rule"), "is '" + word + "'", "use as-read or interpolate");
  }
  rule.kind = kind.value_or(rule.kind);
  rule.maxAgeS = json.number(node, "max_age_s", rule.maxAgeS, 1e-6, 60.0);
  return rule;
}

bool isPath(std::string_view name) { return name.contains('/') || name.ends_with(".json"); }

} // namespace

const BenchInstrument* SavedBench::filling(InstrumentRole role) const {
  const auto found = std::ranges::find_if(
      instruments, [&](const BenchInstrument& one) { return std::ranges::find(one.roles, role) != one.roles.end(); });
  return found == instruments.end() ? nullptr : &*found;
}

Result<SavedBench> benchFromJson(std::string_view text, const std::string& file) {
  nlohmann::json parsed;
  try {
    parsed = nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
    return fail(ErrorKind::Input, "this is no JSON here", whereDescribed,
                file + ":" + std::to_string(1 + std::count(text.begin(), end, '\n')));
  }
  ProfileJson json(text, file);
  const ProfileNode root{&parsed, {}};
  SavedBench bench;
  if (json.object(root, {"$schema", "comment", "format", "version", "name", "pairing", "instruments"})) {
    if (json.requiredText(root, "format") != "straightedge-bench" || json.integer(root, "version", 1, 1, 1) != 1) {
      json.blame(root.member("format"), "is not straightedge-bench, version 1", whereDescribed);
    }
    bench.name = json.requiredText(root, "name");
    bench.pairing = benchPairing(json, root.member("pairing"));
    std::set<InstrumentRole> taken;
    const auto items = json.items(root, "instruments");
    if (items.empty() || items.size() > mostInstruments) {
      json.blame(root.member("instruments"), "names no instruments, or too many", whereDescribed);
    }
    for (const ProfileNode& item : items) {
      bench.instruments.push_back(benchInstrument(json, item, taken));
    }
  }
  if (json.problem()) {
    Error error = *json.problem();
    if (error.remedy.contains("schema")) { // the remedy of profiles, whose reader this is
      error.remedy = whereDescribed;
    }
    return std::unexpected(std::move(error));
  }
  return bench;
}

std::string benchToJson(const SavedBench& bench) {
  JsonWriter json;
  json.beginObject();
  json.member("format", "straightedge-bench");
  json.member("version", 1);
  json.member("name", std::string_view(bench.name));
  json.openObject("pairing", true);
  json.member("rule", pairingWord(bench.pairing.kind));
  json.member("max_age_s", bench.pairing.maxAgeS);
  json.endObject();
  json.openList("instruments");
  for (const BenchInstrument& one : bench.instruments) {
    json.beginObject();
    json.member("instrument", std::string_view(one.instrument));
    json.openList("roles", true);
    for (const InstrumentRole role : one.roles) {
      json.value(roleWord(role));
    }
    json.endList();
    json.member(one.serial.empty() ? "port" : "serial", std::string_view(one.serial.empty() ? one.port : one.serial));
    json.openObject("settings");
    for (const auto& [key, value] : one.settings) {
      json.member(key, std::string_view(value));
    }
    json.endObject();
    json.member("latency_s", one.latencyS);
    if (one.baud) {
      json.member("baud", *one.baud);
    }
    json.endObject();
  }
  json.endList();
  json.endObject();
  return json.take();
}

std::string userBenchFolder() {
  namespace fs = std::filesystem;
  const char* config = std::getenv("XDG_CONFIG_HOME");
  const char* home = std::getenv("HOME");
  if (config != nullptr && config[0] == '/') { // the specification wants relative paths to be ignored
    return (fs::path(config) / "straightedge" / "benches").string();
  }
  if (home != nullptr && home[0] != '\0') {
    return (fs::path(home) / ".config" / "straightedge" / "benches").string();
  }
  return {};
}

std::string benchFile(const std::string& name) {
  return isPath(name) ? name : userBenchFolder() + "/" + name + ".json";
}

Result<SavedBench> readBench(const std::string& name) {
  const std::string file = benchFile(name);
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) {
    return fail(ErrorKind::Instrument, "there is no bench named '" + name + "'",
                "give --bench simulated, or describe the bench in " + file);
  }
  const auto text = readFileBytes(file);
  if (!text) {
    return std::unexpected(text.error());
  }
  return benchFromJson(*text, file);
}

Result<std::string> saveBench(const SavedBench& bench) {
  const std::string folder = userBenchFolder();
  if (folder.empty()) {
    return fail(ErrorKind::Storage, "there is no folder for benches", "set HOME or XDG_CONFIG_HOME");
  }
  if (bench.name.empty() || isPath(bench.name) || bench.name.starts_with('.') || bench.name == "simulated") {
    return fail(ErrorKind::Usage, "'" + bench.name + "' cannot be the name of a bench", "choose a word without '/'");
  }
  if (auto made = makeFolder(folder); !made) {
    return std::unexpected(std::move(made.error()));
  }
  const std::string file = benchFile(bench.name);
  if (auto written = writeFileWhole(file, benchToJson(bench)); !written) {
    return std::unexpected(std::move(written.error()));
  }
  return file;
}

} // namespace straightedge::devices
