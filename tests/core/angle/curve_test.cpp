#include "core/angle/curve.h"
#include "core/angle/sweep_csv.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <complex>
#include <fstream>
#include <numbers>
#include <string>

namespace straightedge::angle {
namespace {

const std::string dataFolder = STRAIGHTEDGE_TEST_DATA "/angle/";

Sweep sideShaft() {
  auto sweep = readSweepCsv(dataFolder + "side_shaft_32.csv");
  EXPECT_TRUE(sweep.has_value());
  return sweep.value_or(Sweep{});
}

std::complex<double> harmonicOf(const Eigen::VectorXd& grid, int order) {
  std::complex<double> sum = 0.0;
  for (Eigen::Index i = 0; i < grid.size(); ++i) {
    const double phase = -2.0 * std::numbers::pi * order * static_cast<double>(i) / static_cast<double>(grid.size());
    sum += grid(i) * std::polar(1.0, phase);
  }
  return sum / static_cast<double>(grid.size());
}

TEST(Curve, SideShaftAgreesWithThePublishedMethodToAMillionth) {
  const auto aligned = alignSweep(sideShaft());
  ASSERT_TRUE(aligned.has_value()) << aligned.error().message();
  const auto curve = fitCurve(*aligned);
  ASSERT_TRUE(curve.has_value()) << curve.error().message();
  EXPECT_EQ(curve->method, CurveMethod::Interpolate);
  EXPECT_EQ(curve->resolvableHarmonics, 16);
  const auto expected = nlohmann::json::parse(std::ifstream(dataFolder + "side_shaft_32_expected.json"));
  EXPECT_NEAR(curve->gridDeg.mean(), expected["harmonics"]["offset_deg"].get<double>(), 1e-6);
  for (int order = 1; order <= 16; ++order) {
    const std::complex<double> harmonic = 2.0 * harmonicOf(curve->gridDeg, order);
    const auto index = static_cast<std::size_t>(order - 1);
    EXPECT_NEAR(std::abs(harmonic), expected["harmonics"]["terms"][index]["amplitude_deg"].get<double>(), 1e-6)
        << order;
    EXPECT_NEAR(std::arg(harmonic), expected["harmonics"]["terms"][index]["phase_rad"].get<double>(), 1e-6) << order;
  }
}

} // namespace
} // namespace straightedge::angle
