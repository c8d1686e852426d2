#include "devices/instruments/instrument_settings.h"

#include "core/base/number_text.h"

#include <algorithm>

namespace straightedge::devices {

SettingReader::SettingReader(const SettingValues& values, const std::vector<SettingDescription>& descriptions,
                             std::string where)
    : m_values(values), m_descriptions(descriptions), m_where(std::move(where)) {
  for (const auto& [key, value] : values) {
    if (find(key) == nullptr) {
      blame(key, "is no setting of this instrument");
    }
  }
}

const SettingDescription* SettingReader::find(std::string_view key) const {
  const auto found = std::ranges::find(m_descriptions, key, &SettingDescription::key);
  return found == m_descriptions.end() ? nullptr : &*found;
}

void SettingReader::blame(std::string_view key, const std::string& what) {
  if (m_problem) {
    return;
  }
  const SettingDescription* described = find(key);
  std::string remedy = "choose another value";
  if (described == nullptr) {
    remedy = "take it out of the bench's settings";
  } else if (!described->help.empty()) {
    remedy = "give " + std::string(described->help);
  }
  m_problem = Error{ErrorKind::Usage, "the setting '" + std::string(key) + "' " + what, std::move(remedy), m_where};
}

std::string SettingReader::text(std::string_view key) {
  const SettingDescription* described = find(key);
  const auto given = m_values.find(key);
  std::string value = given != m_values.end() ? given->second
                      : described != nullptr  ? std::string(described->fallback)
                                              : "";
  if (described != nullptr && !described->choices.empty() &&
      std::ranges::find(described->choices, value) == described->choices.end()) {
    std::string list;
    for (const std::string_view choice : described->choices) {
      list += (list.empty() ? "" : ", ") + std::string(choice);
    }
    blame(key, "is '" + value + "' and not one of " + list);
    value = described->fallback;
  }
  return value;
}

double SettingReader::number(std::string_view key, double least, double most) {
  const std::string value = text(key);
  if (value.empty()) {
    blame(key, "is missing");
    return least;
  }
  const auto parsed = parseDouble(value);
  if (!parsed || !(*parsed >= least && *parsed <= most)) {
    blame(key, "is '" + value + "' and not a number from " + formatForPeople(least) + " to " + formatForPeople(most));
    return least;
  }
  return *parsed;
}

std::optional<double> SettingReader::numberIfGiven(std::string_view key, double least, double most) {
  if (text(key).empty()) {
    return std::nullopt;
  }
  return number(key, least, most);
}

int SettingReader::integer(std::string_view key, int least, int most) {
  const std::string value = text(key);
  if (value.empty()) {
    blame(key, "is missing");
    return least;
  }
  const auto parsed = parseInt(value);
  if (!parsed || *parsed < least || *parsed > most) {
    blame(key,
          "is '" + value + "' and not a whole number from " + std::to_string(least) + " to " + std::to_string(most));
    return least;
  }
  return *parsed;
}

bool SettingReader::yes(std::string_view key) { return text(key) == "yes"; }

} // namespace straightedge::devices
