// Settings of the simulated bench as the JSON that a session keeps, so that a sweep is resumed on the same bench.
#pragma once

#include "devices/simulated/simulated_angle_bench.h"

#include <string>
#include <string_view>

namespace straightedge::devices {

std::string simulatedSettingsToJson(const SimulatedAngleSettings& settings);
/// What is missing keeps its default. Errors: Input, not JSON or of a wrong kind.
Result<SimulatedAngleSettings> simulatedSettingsFromJson(std::string_view json);

} // namespace straightedge::devices
