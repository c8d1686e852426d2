#include "devices/instruments/instrument.h"

#include <algorithm>
#include <array>
#include <utility>

namespace straightedge::devices {

namespace {

using Role = InstrumentRole;

constexpr std::array<std::pair<Role, std::string_view>, 7> roleWords = {
    {{Role::AngleSensor, "angle-sensor"},
     {Role::AngleReference, "angle-reference"},
     {Role::FieldProbe, "field-probe"},
     {Role::FieldReference, "field-reference"},
     {Role::Resistance, "resistance"},
     {Role::Temperature, "temperature"},
     {Role::ChamberTemperature, "chamber-temperature"}}};

} // namespace

std::string_view roleWord(InstrumentRole role) {
  return std::ranges::find(roleWords, role, &std::pair<Role, std::string_view>::first)->second;
}

std::optional<InstrumentRole> roleFromWord(std::string_view word) {
  const auto found = std::ranges::find(roleWords, word, &std::pair<Role, std::string_view>::second);
  return found == roleWords.end() ? std::nullopt : std::optional(found->first);
}

InstrumentRole abilityFor(InstrumentRole role) { return role == Role::ChamberTemperature ? Role::Temperature : role; }

} // namespace straightedge::devices
