#include "tests/core/field/sample_chain.h"

#include <random>

namespace straightedge::testing {

field::CorrectionChain sampleChain() {
  field::CorrectionChain chain;
  chain.pt100 = field::Pt100Line{2.59, -282.9};
  for (std::size_t i = 0; i < chain.axes.size(); ++i) {
    const double part = 1.0 + 0.1 * static_cast<double>(i);
    field::AxisChain& axis = chain.axes[i];
    axis.nonlinearity = {1e-4 * part, 1.03, 2e-4, -0.018 * part, 1e-5, 0.004};
    axis.offsetT = {{2.4e-5, 1.578e-5 * part}};
    axis.sensitivitySlope = std::vector<double>{1e-6, -4e-4 * part, 1e-6, 2e-5};
    axis.sensitivityIntercept = std::vector<double>{3e-5, -2e-4};
    axis.electronicsT = {{1e-5 * part, -1.2e-5}};
    axis.electronicsSensitivity = {{2e-7, 3e-5 * part}};
  }
  chain.axisMatrix.emplace();
  *chain.axisMatrix << 0.99998, 0.012, -0.009, -0.015, 0.99998, 0.011, 0.008, -0.013, 0.99998;
  return chain;
}

SampleReadings sampleReadings(std::size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  const auto uniform = [&random](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11U) * 0x1p-53;
  };
  SampleReadings readings;
  for (std::size_t i = 0; i < count; ++i) {
    readings.pt100Ohm.push_back(uniform(103.9, 115.5));
    readings.electronicsC.push_back(uniform(10.0, 40.0));
    readings.x.push_back(uniform(-2.0, 2.0));
    readings.y.push_back(uniform(-2.0, 2.0));
    readings.z.push_back(uniform(-2.0, 2.0));
  }
  return readings;
}

} // namespace straightedge::testing
