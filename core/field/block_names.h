// The words that files, messages and tables use for blocks, states and methods.
#pragma once

#include "core/field/calibration.h"

#include <array>
#include <string_view>
#include <utility>

namespace straightedge::field {

inline constexpr std::array<std::pair<Block, std::string_view>, 7> blockWords{{
    {Block::Nonlinearity, "nonlinearity"},
    {Block::ProbeTemperature, "probe-temperature"},
    {Block::Offset, "offset"},
    {Block::Sensitivity, "sensitivity"},
    {Block::Electronics, "electronics"},
    {Block::ElectronicsSensitivity, "electronics-sensitivity"},
    {Block::AxisMatrix, "axis-matrix"},
}};

inline constexpr std::array<std::pair<VerifiedState, std::string_view>, 8> stateWords{{
    {VerifiedState::Uncalibrated, "uncalibrated"},
    {VerifiedState::Nonlinearity, "nonlinearity"},
    {VerifiedState::Offset, "offset"},
    {VerifiedState::Sensitivity, "sensitivity"},
    {VerifiedState::Electronics, "electronics"},
    {VerifiedState::ElectronicsSensitivity, "electronics-sensitivity"},
    {VerifiedState::Calibrated, "calibrated"},
    {VerifiedState::AxisMatrix, "axis-matrix"},
}};

inline constexpr std::array<std::pair<FitMethod, std::string_view>, 2> methodWords{{
    {FitMethod::Stepwise, "stepwise"},
    {FitMethod::Joint, "joint"},
}};

inline constexpr std::array<std::pair<Axis, std::string_view>, 3> axisWords{{
    {Axis::X, "x"},
    {Axis::Y, "y"},
    {Axis::Z, "z"},
}};

constexpr std::string_view blockName(Block block) { return blockWords[static_cast<std::size_t>(block)].second; }
constexpr std::string_view stateName(VerifiedState state) { return stateWords[static_cast<std::size_t>(state)].second; }

} // namespace straightedge::field
