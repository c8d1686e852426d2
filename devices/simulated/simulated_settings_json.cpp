#include "devices/simulated/simulated_settings_json.h"

#include <nlohmann/json.hpp>

namespace straightedge::devices {

std::string simulatedSettingsToJson(const SimulatedAngleSettings& settings) {
  const nlohmann::ordered_json json = {
      {"bench", "simulated"},
      {"geometry", settings.geometry == FieldGeometry::OnAxis ? "on-axis" : "side-shaft"},
      {"ellipticity", settings.ellipticity},
      {"eccentricity", settings.eccentricity},
      {"mounting_angle_deg", settings.mountingAngleDeg},
      {"decreasing", settings.decreasing},
      {"noise_deg", settings.noiseDeg},
      {"hysteresis_deg", settings.hysteresisDeg},
      {"sensor_bits", settings.sensorBits},
      {"encoder_step_deg", settings.encoderStepDeg},
      {"ambient_C", settings.ambientC},
      {"stage_speed_deg_per_s", settings.stageSpeedDegPerS},
      {"real_time", settings.realTime},
      {"seed", settings.seed}};
  return json.dump();
}

Result<SimulatedAngleSettings> simulatedSettingsFromJson(std::string_view text) {
  SimulatedAngleSettings settings;
  try {
    const auto json = nlohmann::json::parse(text);
    settings.geometry =
        json.value("geometry", "side-shaft") == "on-axis" ? FieldGeometry::OnAxis : FieldGeometry::SideShaft;
    settings.ellipticity = json.value("ellipticity", settings.ellipticity);
    settings.eccentricity = json.value("eccentricity", settings.eccentricity);
    settings.mountingAngleDeg = json.value("mounting_angle_deg", settings.mountingAngleDeg);
    settings.decreasing = json.value("decreasing", settings.decreasing);
    settings.noiseDeg = json.value("noise_deg", settings.noiseDeg);
    settings.hysteresisDeg = json.value("hysteresis_deg", settings.hysteresisDeg);
    settings.sensorBits = json.value("sensor_bits", settings.sensorBits);
    settings.encoderStepDeg = json.value("encoder_step_deg", settings.encoderStepDeg);
    settings.ambientC = json.value("ambient_C", settings.ambientC);
    settings.stageSpeedDegPerS = json.value("stage_speed_deg_per_s", settings.stageSpeedDegPerS);
    settings.realTime = json.value("real_time", settings.realTime);
    settings.seed = json.value("seed", settings.seed);
  } catch (const nlohmann::json::exception& problem) {
    return fail(ErrorKind::Input,
                std::string("the stored settings of the simulated bench cannot be read (") + problem.what() + ")",
                "start a new session", "simulated bench");
  }
  return settings;
}

} // namespace straightedge::devices
