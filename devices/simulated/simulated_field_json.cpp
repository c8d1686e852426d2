// Settings of the simulated field bench as JSON.
#include "devices/simulated/simulated_field_bench.h"

#include <nlohmann/json.hpp>

namespace straightedge::devices {

namespace {

using Json = nlohmann::ordered_json;

/// One list of names for both ways. `pass(json, name, value)` reads or writes.
template <typename Axis, typename Pass>
void passAxis(Axis& axis, const Pass& pass) {
  pass("raw_over_field_T", axis.rawOverFieldT);
  pass("offset_T", axis.offsetT);
  pass("sensitivity_slope", axis.sensitivitySlope);
  pass("sensitivity_intercept", axis.sensitivityIntercept);
  pass("electronics_T", axis.electronicsT);
  pass("electronics_sensitivity", axis.electronicsSensitivity);
  pass("planar_hall_per_T", axis.planarHallPerT);
}

template <typename Settings, typename Pass>
void passNumbers(Settings& settings, const Pass& pass) {
  pass("full_scale_T", settings.probe.fullScaleT);
  pass("reference_temperature_C", settings.probe.referenceTemperatureC);
  pass("noise_T", settings.probe.noiseT);
  pass("step_T", settings.probe.stepT);
  pass("pt100_ohm_at_0_C", settings.probe.pt100OhmAt0C);
  pass("pt100_ohm_per_C", settings.probe.pt100OhmPerC);
  pass("pt100_noise_ohm", settings.probe.pt100NoiseOhm);
  pass("pt100_step_ohm", settings.probe.pt100StepOhm);
  pass("electronics_noise_C", settings.probe.electronicsNoiseC);
  pass("electronics_step_C", settings.probe.electronicsStepC);
  pass("room_C", settings.roomC);
  pass("magnet_lag_s", settings.magnetLagS);
  pass("chamber_lag_s", settings.chamberLagS);
  pass("probe_lag_s", settings.probeLagS);
  pass("placing_s", settings.placingS);
  pass("largest_field_T", settings.largestFieldT);
  pass("pole_drift_ppm_per_C", settings.poleDriftPpmPerC);
  pass("lock_threshold_T", settings.lockThresholdT);
  pass("lock_gradient_ppm", settings.lockGradientPpm);
  pass("search_s", settings.searchS);
  pass("reference_noise_ppm", settings.referenceNoisePpm);
  pass("reference_scale_ppm", settings.referenceScalePpm);
  pass("by_hand", settings.byHand);
  pass("real_time", settings.realTime);
  pass("seed", settings.seed);
}

} // namespace

std::string simulatedFieldSettingsToJson(const SimulatedFieldSettings& settings) {
  Json json = {{"bench", "simulated"}, {"field_over_raw", settings.probe.curve == HallCurve::FieldOverRaw}};
  passNumbers(settings, [&json](const char* name, const auto& value) { json[name] = value; });
  for (const HallAxis& axis : settings.probe.axes) {
    Json part;
    passAxis(axis, [&part](const char* name, const auto& value) { part[name] = value; });
    json["axes"].push_back(std::move(part));
  }
  for (const auto& row : settings.probe.axisMatrix.rowwise()) {
    json["axis_matrix"].push_back({row[0], row[1], row[2]});
  }
  return json.dump();
}

Result<SimulatedFieldSettings> simulatedFieldSettingsFromJson(std::string_view text) {
  SimulatedFieldSettings settings;
  const auto reader = [](const Json& json) {
    return [&json](const char* name, auto& value) {
      if (json.contains(name)) {
        json.at(name).get_to(value);
      }
    };
  };
  try {
    const Json json = Json::parse(text);
    passNumbers(settings, reader(json));
    settings.probe.curve = json.value("field_over_raw", false) ? HallCurve::FieldOverRaw : HallCurve::RawOverField;
    for (std::size_t i = 0; json.contains("axes") && i < 3; ++i) {
      passAxis(settings.probe.axes[i], reader(json.at("axes").at(i)));
    }
    for (std::size_t i = 0; json.contains("axis_matrix") && i < 9; ++i) {
      settings.probe.axisMatrix(static_cast<Eigen::Index>(i / 3), static_cast<Eigen::Index>(i % 3)) =
          json.at("axis_matrix").at(i / 3).at(i % 3).get<double>();
    }
  } catch (const nlohmann::json::exception& problem) {
    return fail(ErrorKind::Input,
                std::string("the stored settings of the simulated bench cannot be read (") + problem.what() + ")",
                "start a new session", "simulated bench");
  }
  return settings;
}

} // namespace straightedge::devices
