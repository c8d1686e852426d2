// The words that files, messages and tables use for axes, orientations and steps.
#pragma once

#include "core/field/campaign.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace straightedge::field {

inline constexpr std::array<Orientation, 6> allOrientations = {Orientation::PlusX, Orientation::MinusX,
                                                               Orientation::PlusY, Orientation::MinusY,
                                                               Orientation::PlusZ, Orientation::MinusZ};
inline constexpr std::array<CampaignStep, 8> allSteps = {
    CampaignStep::Nonlinearity, CampaignStep::ProbeTemperature, CampaignStep::Offset,
    CampaignStep::Sensitivity,  CampaignStep::Electronics,      CampaignStep::ElectronicsSensitivity,
    CampaignStep::Orientation,  CampaignStep::Verification};

constexpr std::size_t indexOf(Axis axis) { return static_cast<std::size_t>(axis); }
constexpr std::size_t indexOf(CampaignStep step) { return static_cast<std::size_t>(step); }

constexpr std::string_view axisName(Axis axis) { return axis == Axis::X ? "x" : axis == Axis::Y ? "y" : "z"; }
constexpr std::string_view orientationName(Orientation orientation) {
  constexpr std::array<std::string_view, 6> names = {"+x", "-x", "+y", "-y", "+z", "-z"};
  return names[static_cast<std::size_t>(orientation)];
}
/// As in campaign.csv: "probe-temperature".
constexpr std::string_view stepName(CampaignStep step) {
  constexpr std::array<std::string_view, 8> names = {"nonlinearity", "probe-temperature", "offset",
                                                     "sensitivity",  "electronics",       "electronics-sensitivity",
                                                     "orientation",  "verification"};
  return names[indexOf(step)];
}
constexpr Axis axisOf(Orientation orientation) { return allAxes[static_cast<std::size_t>(orientation) / 2]; }
constexpr bool isMinus(Orientation orientation) { return static_cast<std::size_t>(orientation) % 2 == 1; }

std::optional<Axis> parseAxis(std::string_view text);
std::optional<Orientation> parseOrientation(std::string_view text); ///< "+x", "x" or "-x"
std::optional<CampaignStep> parseStep(std::string_view text);       ///< any case; _ or blank for -

} // namespace straightedge::field
