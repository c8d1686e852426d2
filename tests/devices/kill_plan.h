// The plans of the kill test: long enough that a hundred kills do not see their end in real time.
#pragma once

#include "devices/capture/angle_plan.h"

namespace straightedge::tests {

inline constexpr devices::AnglePlan stepwiseKillPlan{
    .pointsPerTurn = 6000, .turns = 2, .settleS = 0.001, .averages = 2};
inline constexpr devices::AnglePlan freeRunningKillPlan{.pointsPerTurn = 72, .turns = 8, .sampleRateHz = 2000.0};

} // namespace straightedge::tests
