#include "core/angle/sweep_columns.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace straightedge::angle {

namespace {

/// A title taken apart: words in lower case, unit from brackets or from a last word such as "_deg".
struct Title {
  std::vector<std::string> words;
  std::string unit;
};

std::string lowered(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return lower;
}

bool isOneOf(std::string_view text, std::initializer_list<std::string_view> list) {
  return std::find(list.begin(), list.end(), text) != list.end();
}

/// The degree sign alone, in UTF-8 (also its look-alike º) or Latin-1.
bool isDegreeSign(std::string_view text) { return isOneOf(text, {"\xC2\xB0", "\xC2\xBA", "\xB0"}); }

bool isAngleUnit(std::string_view unit) {
  return unit.empty() || isDegreeSign(unit) || isOneOf(unit, {"deg", "degs", "degree", "degrees"});
}

bool isCelsius(std::string_view unit) {
  const bool withSign = unit.size() > 1 && unit.back() == 'c' && isDegreeSign(unit.substr(0, unit.size() - 1));
  return unit.empty() || withSign || isOneOf(unit, {"c", "degc", "deg c", "celsius"});
}

bool isSecond(std::string_view unit) { return unit.empty() || isOneOf(unit, {"s", "sec", "second", "seconds"}); }

Title takeApart(std::string_view text) {
  Title title;
  const std::string lower = lowered(text);
  std::string_view rest = lower;
  const auto open = rest.find_first_of("[(");
  if (open != std::string_view::npos) {
    const auto close = rest.find_first_of("])", open);
    title.unit = rest.substr(open + 1, close == std::string_view::npos ? close : close - open - 1);
    rest = rest.substr(0, open);
  }
  const auto isWordByte = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) >= 0x80U;
  };
  std::string word;
  for (std::size_t i = 0; i <= rest.size(); ++i) {
    const bool inside = i < rest.size() && isWordByte(rest[i]);
    // "EncoderAngle" is two words
    const bool hump = inside && !word.empty() && std::isupper(static_cast<unsigned char>(text[i])) != 0 &&
                      std::islower(static_cast<unsigned char>(text[i - 1])) != 0;
    if ((!inside || hump) && !word.empty()) {
      title.words.push_back(word);
      word.clear();
    }
    if (inside) {
      word += rest[i];
    }
  }
  if (title.unit.empty() && title.words.size() > 1 &&
      (isDegreeSign(title.words.back()) ||
       isOneOf(title.words.back(),
               {"deg", "degree", "degrees", "rad", "radian", "radians", "c",      "degc", "celsius", "k", "f",
                "s",   "sec",    "ms",      "us",  "min",    "turns",   "counts", "lsb",  "v",       "mv"}))) {
    title.unit = title.words.back();
    title.words.pop_back();
  }
  return title;
}

bool hasWord(const Title& title, std::initializer_list<std::string_view> list) {
  return std::any_of(title.words.begin(), title.words.end(), [&](const auto& word) { return isOneOf(word, list); });
}

bool hasPart(const Title& title, std::string_view part) {
  return std::any_of(title.words.begin(), title.words.end(),
                     [&](const auto& word) { return word.find(part) != std::string::npos; });
}

SweepColumn roleOf(const Title& title) {
  if (hasPart(title, "temperature") || hasWord(title, {"temp", "ambient"})) {
    return isCelsius(title.unit) ? SweepColumn::Temperature : SweepColumn::Ignored;
  }
  if (hasWord(title, {"time", "timestamp"})) {
    return isSecond(title.unit) ? SweepColumn::Time : SweepColumn::Ignored;
  }
  if (hasWord(title, {"direction", "dir"})) {
    return SweepColumn::Direction;
  }
  if (hasPart(title, "error") || hasPart(title, "deviation") || hasPart(title, "correct")) {
    return SweepColumn::Ignored; // "sensor error" is not the sensor's angle
  }
  if (hasPart(title, "encoder") || hasPart(title, "reference") || hasWord(title, {"ref"})) {
    return SweepColumn::Encoder;
  }
  if (hasPart(title, "sensor") || hasPart(title, "measured")) {
    return SweepColumn::Sensor;
  }
  return hasWord(title, {"turn", "turns", "revolution"}) ? SweepColumn::Turn : SweepColumn::Ignored;
}

/// How surely a title speaks of an angle, to choose between "Reference Angle" and "Reference Counts".
int certainty(const Title& title) {
  const bool unitSaysSo = !title.unit.empty() && isAngleUnit(title.unit);
  return (unitSaysSo ? 2 : 0) + (hasPart(title, "angle") ? 1 : 0) - (isAngleUnit(title.unit) ? 0 : 4);
}

/// Where several columns claim a role, the surest keeps it; equals are left for checkMapping() to refuse.
void keepSurest(SweepMapping& mapping, const std::vector<Title>& titles, SweepColumn role) {
  int best = -100;
  for (std::size_t i = 0; i < mapping.size(); ++i) {
    best = mapping[i] == role ? std::max(best, certainty(titles[i])) : best;
  }
  for (std::size_t i = 0; i < mapping.size(); ++i) {
    if (mapping[i] == role && certainty(titles[i]) < best) {
      mapping[i] = SweepColumn::Ignored;
    }
  }
}

} // namespace

SweepMapping guessMapping(const CsvTable& table) {
  SweepMapping mapping(table.columns(), SweepColumn::Ignored);
  if (!table.layout().hasHeader) {
    if (mapping.size() == 2) {
      mapping = {SweepColumn::Encoder, SweepColumn::Sensor};
    }
    return mapping;
  }
  std::vector<Title> titles;
  for (std::size_t i = 0; i < mapping.size(); ++i) {
    titles.push_back(takeApart(table.title(i)));
    mapping[i] = roleOf(titles.back());
  }
  for (const auto role : {SweepColumn::Encoder, SweepColumn::Sensor}) {
    keepSurest(mapping, titles, role);
  }
  for (const auto role : {SweepColumn::Turn, SweepColumn::Direction, SweepColumn::Temperature, SweepColumn::Time}) {
    auto found = std::find(mapping.begin(), mapping.end(), role);
    if (found != mapping.end()) { // of an optional column the first one counts
      std::replace(found + 1, mapping.end(), role, SweepColumn::Ignored);
    }
  }
  return mapping;
}

Result<void> checkMapping(const CsvTable& table, const SweepMapping& mapping) {
  if (mapping.size() != table.columns()) {
    return fail(ErrorKind::Usage,
                "the column mapping has " + std::to_string(mapping.size()) + " entries but the file " +
                    std::to_string(table.columns()) + " columns",
                "give one role per column", table.name());
  }
  const bool encoderFound = std::find(mapping.begin(), mapping.end(), SweepColumn::Encoder) != mapping.end();
  const bool sensorFound = std::find(mapping.begin(), mapping.end(), SweepColumn::Sensor) != mapping.end();
  if (!table.layout().hasHeader && !encoderFound && !sensorFound) {
    const std::string count = std::to_string(table.columns());
    return fail(ErrorKind::Input,
                "there is no header and " +
                    (table.columns() == 1 ? "only 1 column" : "there are " + count + " columns"),
                table.columns() == 1 ? "separate encoder and sensor angle by a comma, a semicolon or a tab"
                                     : "add a header with encoder_deg and sensor_deg, or keep two columns",
                table.name());
  }
  for (const auto role : {SweepColumn::Encoder, SweepColumn::Sensor, SweepColumn::Turn, SweepColumn::Direction,
                          SweepColumn::Temperature, SweepColumn::Time}) {
    const bool isAngle = role == SweepColumn::Encoder || role == SweepColumn::Sensor;
    const std::string canonical = sweepColumnTitle(role);
    const auto first = std::find(mapping.begin(), mapping.end(), role);
    if (first == mapping.end()) {
      if (isAngle) {
        return fail(ErrorKind::Input, "no column is the " + canonical.substr(0, canonical.find('_')) + " angle",
                    "name its column " + canonical, table.name());
      }
      continue;
    }
    const auto column = static_cast<std::size_t>(first - mapping.begin());
    const auto second = std::find(first + 1, mapping.end(), role);
    if (second != mapping.end()) {
      return fail(ErrorKind::Input,
                  table.columnName(column) + " and " +
                      table.columnName(static_cast<std::size_t>(second - mapping.begin())) + " may both be " +
                      canonical,
                  "name the right one " + canonical + " and the other differently", table.name());
    }
    const Title title = takeApart(table.title(column));
    if (isAngle && !isAngleUnit(title.unit)) {
      return fail(ErrorKind::Input, table.columnName(column) + " is in " + title.unit + ", not in degrees",
                  "convert it to degrees", table.name());
    }
  }
  return {};
}

std::optional<int> parseDirection(std::string_view text, char decimalPoint) {
  if (const auto number = parseDouble(text, decimalPoint)) {
    return *number > 0.0 ? std::optional(1) : *number < 0.0 ? std::optional(-1) : std::nullopt;
  }
  const std::string word = lowered(text);
  if (isOneOf(word, {"up", "rising", "forward", "increasing", "ccw", "+"})) {
    return 1;
  }
  if (isOneOf(word, {"down", "falling", "backward", "reverse", "decreasing", "cw", "-"})) {
    return -1;
  }
  return std::nullopt;
}

} // namespace straightedge::angle
