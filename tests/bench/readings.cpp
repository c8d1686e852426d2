#include "tests/bench/readings.h"

#include "core/angle/sweep_csv.h"
#include "core/base/number_text.h"

#include <cmath>
#include <cstdlib>
#include <numbers>

namespace straightedge::bench {

std::string sweepText(int seed) {
  constexpr int points = 32;
  std::string text = "encoder_deg,sensor_deg\n";
  for (int i = 0; i < points; ++i) {
    const double encoder = 360.0 * i / points;
    const double phase = encoder * std::numbers::pi / 180.0;
    const double error =
        8.0 * std::sin(phase + 0.001 * seed) + 5.0 * std::cos(2.0 * phase) + 0.3 * std::sin(3.0 * phase);
    const double sensor = std::round(100.0 * std::fmod(encoder + error + 380.0, 360.0)) / 100.0;
    text += formatDouble(encoder) + "," + formatDouble(sensor) + "\n";
  }
  return text;
}

angle::AngleCalibration sampleCalibration() {
  const auto sweep = angle::parseSweepCsv(sweepText(0), "sweep", "sweep");
  auto run = angle::calibrate(*sweep, {}, {});
  return run ? std::move(run->result) : (std::abort(), angle::AngleCalibration{});
}

std::string readingsText(std::size_t bytes) {
  std::string text = "sample,sensor_deg\n";
  text.reserve(bytes + 64);
  for (unsigned row = 10'000'000; text.size() < bytes; ++row) {
    const unsigned part = (row * 2654435761U) % 3'600'000'000U;
    const std::string digits = std::to_string(part % 10'000'000U);
    text += std::to_string(row) + "," + std::to_string(part / 10'000'000U) + "." + std::string(7 - digits.size(), '0') +
            digits + "\n";
  }
  return text;
}

} // namespace straightedge::bench
