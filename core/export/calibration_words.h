// The words that calibration.json uses for enumerations. Private to calibration_json.
#pragma once

#include "core/angle/calibration.h"

#include <array>
#include <string_view>
#include <utility>

namespace straightedge::exporting {

inline constexpr std::array<std::pair<angle::SensorDirection, std::string_view>, 2> directionWords{{
    {angle::SensorDirection::Increasing, "increasing"},
    {angle::SensorDirection::Decreasing, "decreasing"},
}};

inline constexpr std::array<std::pair<angle::CurveMethod, std::string_view>, 3> curveWords{{
    {angle::CurveMethod::Interpolate, "interpolate"},
    {angle::CurveMethod::Regress, "regress"},
    {angle::CurveMethod::Auto, "auto"},
}};

inline constexpr std::array<std::pair<angle::Warning::Topic, std::string_view>, 8> topicWords{{
    {angle::Warning::Topic::FewAngles, "few-angles"},
    {angle::Warning::Topic::FewAnglesForSwing, "few-angles-for-swing"},
    {angle::Warning::Topic::FewerPointsThanSegments, "fewer-points-than-segments"},
    {angle::Warning::Topic::CoverageGap, "coverage-gap"},
    {angle::Warning::Topic::SensorRunsBackwards, "sensor-runs-backwards"},
    {angle::Warning::Topic::BeyondData, "beyond-data"},
    {angle::Warning::Topic::NoisyForModel, "noisy-for-model"},
    {angle::Warning::Topic::Other, "other"},
}};

template <typename Words, typename Value>
constexpr std::string_view wordOf(const Words& words, Value value) {
  for (const auto& [candidate, word] : words) {
    if (candidate == value) {
      return word;
    }
  }
  return words.back().second;
}

} // namespace straightedge::exporting
