#include "core/base/number_text.h"
#include "devices/instruments/profile.h"
#include "devices/instruments/profile_json.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <limits>
#include <numbers>

namespace straightedge::devices {

namespace {

using Role = InstrumentRole;
using nlohmann::json;

constexpr double anyNumber = std::numeric_limits<double>::max();

/// A unit that a profile may give a column in, and what turns it into the role's.
struct UnitRule {
  std::string_view word;
  std::string_view base;
  double scale;
  double offset;
};

constexpr std::array<UnitRule, 13> unitRules = {{{"deg", "deg", 1.0, 0.0},
                                                 {"rad", "deg", 180.0 / std::numbers::pi, 0.0},
                                                 {"turn", "deg", 360.0, 0.0},
                                                 {"T", "T", 1.0, 0.0},
                                                 {"mT", "T", 1e-3, 0.0},
                                                 {"uT", "T", 1e-6, 0.0},
                                                 {"G", "T", 1e-4, 0.0},
                                                 {"kG", "T", 0.1, 0.0},
                                                 {"ohm", "ohm", 1.0, 0.0},
                                                 {"kohm", "ohm", 1e3, 0.0},
                                                 {"C", "C", 1.0, 0.0},
                                                 {"K", "C", 1.0, -273.15},
                                                 {"F", "C", 5.0 / 9.0, -160.0 / 9.0}}};

std::string_view baseUnit(Role role) {
  switch (role) {
  case Role::AngleSensor:
  case Role::AngleReference:
    return "deg";
  case Role::FieldProbe:
  case Role::FieldReference:
    return "T";
  case Role::Resistance:
    return "ohm";
  case Role::Temperature:
  case Role::ChamberTemperature:
    return "C";
  }
  return "";
}

const std::vector<std::string_view>& keysOf(std::string_view object) {
  return std::ranges::find(profileKeys(), object, &ProfileKeys::object)->keys;
}

class ProfileBuilder {
public:
  ProfileBuilder(std::string_view text, const std::string& file) : m_json(text, file) {}

  Profile build(const ProfileNode& root);
  const std::optional<Error>& problem() const { return m_json.problem(); }

private:
  void connections(const ProfileNode& root, Profile& profile);
  std::optional<std::uint16_t> hexId(const ProfileNode& parent, std::string_view key);
  SerialSettings serial(const ProfileNode& node);
  ProfileReading reading(const ProfileNode& node);
  LineColumn column(const ProfileNode& node, Role role);
  void regex(const ProfileNode& node, ProfileReading& reading);

  ProfileJson m_json;
};

std::optional<std::uint16_t> ProfileBuilder::hexId(const ProfileNode& parent, std::string_view key) {
  const ProfileNode node = parent.member(key);
  if (!node) {
    return std::nullopt;
  }
  const std::string digits = m_json.asText(node);
  std::uint16_t id = 0;
  const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), id, 16);
  if (digits.size() != 4 || status != std::errc{} || end != digits.data() + digits.size()) {
    m_json.blame(node, "is not four hexadecimal digits", "write it as lsusb does, for example \"1bfa\"");
    return std::nullopt;
  }
  return id;
}

SerialSettings ProfileBuilder::serial(const ProfileNode& node) {
  SerialSettings settings;
  settings.baud = m_json.integer(node, "baud", 115200, 50, 12'000'000);
  settings.dataBits = m_json.integer(node, "data_bits", 8, 5, 8);
  settings.stopBits = m_json.integer(node, "stop_bits", 1, 1, 2);
  const std::string parity = m_json.text(node, "parity", "none");
  settings.parity = parity == "odd" ? Parity::Odd : parity == "even" ? Parity::Even : Parity::None;
  if (parity != "none" && settings.parity == Parity::None) {
    m_json.blame(node.member("parity"), "is none of none, odd and even");
  }
  const std::string flow = m_json.text(node, "flow", "none");
  settings.flow = flow == "rts-cts"    ? FlowControl::RtsCts
                  : flow == "xon-xoff" ? FlowControl::XonXoff
                                       : FlowControl::None;
  if (flow != "none" && settings.flow == FlowControl::None) {
    m_json.blame(node.member("flow"), "is none of none, rts-cts and xon-xoff");
  }
  settings.dtr = m_json.truth(node, "dtr", true);
  settings.rts = m_json.truth(node, "rts", true);
  return settings;
}

void ProfileBuilder::connections(const ProfileNode& root, Profile& profile) {
  const auto all = m_json.items(root, "transports");
  if (all.empty()) {
    m_json.blame(root.member("transports"), "is missing or empty", "say how it is connected: usbtmc or serial");
  }
  for (const ProfileNode& node : all) {
    if (!m_json.object(node, keysOf("transport"))) {
      return;
    }
    const std::string kind = m_json.requiredText(node, "kind");
    if (kind != "usbtmc" && kind != "serial") {
      m_json.blame(node.member("kind"), "is neither usbtmc nor serial");
      return;
    }
    const Connection connection = kind == "serial" ? Connection::Serial : Connection::Usbtmc;
    if (std::ranges::find(profile.connections, connection) == profile.connections.end()) {
      profile.connections.push_back(connection);
    }
    const auto vendor = hexId(node, "vendor_id");
    const auto product = hexId(node, "product_id");
    if (vendor.has_value() != product.has_value()) {
      m_json.blame(node, "has only one of vendor_id and product_id", "give both or none");
    }
    if (vendor && product) {
      profile.usb.push_back({*vendor, *product});
    }
    if (connection == Connection::Serial) {
      profile.serial = serial(node);
    }
  }
}

LineColumn ProfileBuilder::column(const ProfileNode& node, Role role) {
  LineColumn column;
  if (!m_json.object(node, keysOf("column"))) {
    return column;
  }
  column.quantity = m_json.text(node, "quantity", roleWord(role));
  column.index = m_json.integer(node, "field", 1, 1, 64);
  column.label = m_json.text(node, "label", "");
  column.unit = m_json.text(node, "suffix", "");
  column.unitNeeded = m_json.truth(node, "suffix_needed", false);
  const std::string unit = m_json.text(node, "unit", baseUnit(role));
  const auto rule = std::ranges::find(unitRules, unit, &UnitRule::word);
  if (rule == unitRules.end() || rule->base != baseUnit(role)) {
    std::string known;
    for (const UnitRule& candidate : unitRules) {
      if (candidate.base == baseUnit(role)) {
        known += (known.empty() ? "" : ", ") + std::string(candidate.word);
      }
    }
    m_json.blame(node.member("unit"), "is no unit of the role " + std::string(roleWord(role)), "use one of " + known);
    return column;
  }
  column.scale = m_json.number(node, "scale", 1.0, -anyNumber, anyNumber) * rule->scale;
  column.offset = m_json.number(node, "offset", 0.0, -anyNumber, anyNumber) * rule->scale + rule->offset;
  column.least = m_json.number(node, "least", -anyNumber, -anyNumber, anyNumber);
  column.most = m_json.number(node, "most", anyNumber, -anyNumber, anyNumber);
  return column;
}

void ProfileBuilder::regex(const ProfileNode& node, ProfileReading& reading) {
  const std::string pattern = m_json.text(node, "regex", "");
  if (pattern.empty() || m_json.problem()) {
    return;
  }
  constexpr std::size_t longestPattern = 300;
  if (pattern.size() > longestPattern) {
    m_json.blame(node.member("regex"), "is longer than " + std::to_string(longestPattern) + " bytes", "shorten it");
    return;
  }
  try {
    auto flags = std::regex::ECMAScript | std::regex::optimize;
#ifdef __GLIBCXX__
    flags |= std::regex_constants::__polynomial; // a pattern like (a+)+b must not take minutes; refuses back-references
#endif
    auto compiled = std::make_shared<const std::regex>(pattern, flags);
    if (compiled->mark_count() != reading.format.columns.size()) {
      m_json.blame(node.member("regex"),
                   "has " + std::to_string(compiled->mark_count()) + " groups for " +
                       std::to_string(reading.format.columns.size()) + " columns",
                   "put each number in parentheses of its own");
    }
    reading.regex = std::move(compiled);
  } catch (const std::regex_error&) {
    m_json.blame(node.member("regex"), "is no regular expression", "use ECMAScript's rules, without back-references");
  }
}

ProfileReading ProfileBuilder::reading(const ProfileNode& node) {
  ProfileReading reading;
  if (!m_json.object(node, keysOf("reading"))) {
    return reading;
  }
  const std::string word = m_json.requiredText(node, "role");
  const auto role = roleFromWord(word);
  if (!role || *role == Role::ChamberTemperature) { // which temperature it is, is the bench's to say
    m_json.blame(node.member("role"), "is no role",
                 "use angle-sensor, angle-reference, field-probe, field-reference, resistance or temperature");
    return reading;
  }
  reading.role = *role;
  reading.command = m_json.text(node, "command", "");
  reading.setUp = m_json.texts(node, "set_up");
  reading.deadline = Milliseconds{static_cast<int>(1000.0 * m_json.number(node, "deadline_s", 2.0, 0.01, 600.0))};
  reading.latencyS = m_json.number(node, "latency_s", 0.0, 0.0, 60.0);
  reading.keepsZero = m_json.truth(node, "keeps_zero", false);
  reading.noReading = m_json.texts(node, "no_reading");
  reading.format.separators = m_json.text(node, "separators", reading.format.separators);
  reading.format.prefix = m_json.text(node, "prefix", "");
  reading.format.fieldCount = m_json.integer(node, "fields", 0, 0, 64);
  const std::string point = m_json.text(node, "decimal_point", ".");
  reading.format.decimalPoint = point.size() == 1 ? point[0] : '?';
  const auto columns = m_json.items(node, "columns");
  const std::size_t wanted = *role == Role::FieldProbe ? 3 : 1;
  if (columns.size() != wanted) {
    m_json.blame(node.member("columns"), "has " + std::to_string(columns.size()) + " columns",
                 "give " + std::to_string(wanted) + (wanted == 3 ? ": x, y, z" : ""));
    return reading;
  }
  for (const ProfileNode& item : columns) {
    reading.format.columns.push_back(column(item, *role));
  }
  regex(node, reading);
  if (reading.regex && reading.command.empty()) {
    m_json.blame(node.member("regex"), "goes with a command only", "describe lines by columns, separators and labels");
  }
  if (const std::string wrong = problemOf(reading.format); !wrong.empty()) {
    m_json.blame(node, "cannot be read: " + wrong);
  }
  return reading;
}

Profile ProfileBuilder::build(const ProfileNode& root) {
  Profile profile;
  if (!m_json.object(root, keysOf("profile"))) {
    return profile;
  }
  if (m_json.requiredText(root, "format") != "straightedge-instrument") {
    m_json.blame(root.member("format"), "is not straightedge-instrument");
  }
  m_json.integer(root, "version", 1, 1, 1);
  profile.name = m_json.requiredText(root, "name");
  profile.notYetTried = m_json.truth(root, "not_yet_tried", true);
  profile.unconfirmed = m_json.text(root, "unconfirmed", "");
  profile.commandEnd = m_json.text(root, "command_end", "\n");
  profile.replyEnd = m_json.text(root, "reply_end", "\n");
  if (profile.replyEnd.empty()) {
    m_json.blame(root.member("reply_end"), "is empty", "say what ends a reply, for example \"\\r\\n\"");
  }
  profile.deadline = Milliseconds{static_cast<int>(1000.0 * m_json.number(root, "deadline_s", 1.0, 0.01, 600.0))};
  profile.pauseS = m_json.number(root, "pause_s", 0.0, 0.0, 10.0);
  profile.setUp = m_json.texts(root, "set_up");
  profile.errorQuery = m_json.text(root, "error_query", "");
  connections(root, profile);
  if (const ProfileNode node = root.member("identification"); node && m_json.object(node, keysOf("identification"))) {
    profile.identityCommand = m_json.requiredText(node, "command");
    profile.identityParts = m_json.texts(node, "contains");
    if (profile.identityParts.empty()) {
      m_json.blame(node.member("contains"), "is missing", "say which text its reply contains");
    }
  }
  const auto readings = m_json.items(root, "readings");
  if (readings.empty()) {
    m_json.blame(root.member("readings"), "is missing or empty", "say what it measures, and how that is read");
  }
  for (const ProfileNode& node : readings) {
    profile.readings.push_back(reading(node));
    const Role role = profile.readings.back().role;
    if (std::ranges::count(profile.readings, role, &ProfileReading::role) > 1) {
      m_json.blame(node.member("role"), "is read twice", "leave one reading for each role");
    }
  }
  return profile;
}

std::string whereItStops(std::string_view text, std::size_t byte, const std::string& file) {
  const auto before = text.substr(0, std::min(byte == 0 ? 0 : byte - 1, text.size()));
  return file + ":" + std::to_string(std::ranges::count(before, '\n') + 1);
}

} // namespace

const std::vector<ProfileKeys>& profileKeys() {
  static const std::vector<ProfileKeys> all = {
      {"profile",
       {"$schema", "comment", "format", "version", "name", "source", "not_yet_tried", "unconfirmed", "transports",
        "command_end", "reply_end", "deadline_s", "pause_s", "identification", "set_up", "error_query", "readings"}},
      {"transport",
       {"kind", "vendor_id", "product_id", "baud", "data_bits", "stop_bits", "parity", "flow", "dtr", "rts"}},
      {"identification", {"command", "contains"}},
      {"reading",
       {"comment", "role", "command", "set_up", "deadline_s", "latency_s", "separators", "decimal_point", "prefix",
        "fields", "regex", "no_reading", "keeps_zero", "columns"}},
      {"column",
       {"quantity", "field", "label", "suffix", "suffix_needed", "unit", "scale", "offset", "least", "most"}}};
  return all;
}

Result<Profile> parseProfile(std::string_view text, const std::string& file) {
  json parsed;
  try {
    parsed = json::parse(text);
  } catch (const json::parse_error& error) {
    return fail(ErrorKind::Input, "this is not JSON", "look for a missing comma, quote or bracket",
                whereItStops(text, error.byte, file));
  } catch (const json::exception&) {
    return fail(ErrorKind::Input, "a number is too large to be read", "write a smaller one", file);
  }
  ProfileBuilder builder(text, file);
  Profile profile = builder.build({&parsed, {}});
  if (builder.problem()) {
    return std::unexpected(*builder.problem());
  }
  profile.file = file;
  profile.id = std::filesystem::path(file).stem().string();
  return profile;
}

std::expected<std::vector<double>, std::string> parseReading(const ProfileReading& reading, std::string_view reply) {
  if (!reading.regex) {
    auto values = parseLine(reading.format, reply);
    return values ? std::expected<std::vector<double>, std::string>(*std::move(values))
                  : std::unexpected(describe(values.error(), reading.format));
  }
  std::match_results<std::string_view::const_iterator> match;
  // Beyond this length libstdc++'s matcher may run out of stack.
  if (reply.size() > longestLine || !std::regex_search(reply.begin(), reply.end(), match, *reading.regex)) {
    return std::unexpected("the reply does not match the profile's regex");
  }
  std::vector<double> values;
  for (std::size_t i = 0; i < reading.format.columns.size(); ++i) {
    // Each group is a line of one field to the column it belongs to.
    LineFormat one{.separators = "",
                   .decimalPoint = reading.format.decimalPoint,
                   .prefix = {},
                   .columns = {reading.format.columns[i]}};
    one.columns[0].index = 1;
    one.columns[0].label.clear();
    const auto& group = match[i + 1];
    const auto value = parseLine(one, group.matched ? std::string_view(group.first, group.second) : std::string_view());
    if (!value) {
      return std::unexpected(describe(value.error(), one));
    }
    values.push_back(value->front());
  }
  return values;
}

} // namespace straightedge::devices
