#include "core/field/reading_noise.h"

#include "core/field/names.h"
#include "core/field/plateaus.h"
#include "core/numerics/statistics.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace straightedge::field {

namespace {

void pool(const Eigen::Ref<const Eigen::VectorXd>& values, numerics::PooledDeviation& deviation) {
  if (values.size() > 1 && values.allFinite()) {
    deviation.add((values.array() - values.mean()).square().sum(), static_cast<std::size_t>(values.size()));
  }
}

/// Smallest difference between two values that differ; 0 where all are equal.
double stepOf(std::vector<double> values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  std::sort(values.begin(), values.end());
  double step = 0.0;
  constexpr double same = 1e-9; // what is left of decimal digits
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double gap = values[i] - values[i - 1];
    if (gap > same && (step == 0.0 || gap < step)) {
      step = gap;
    }
  }
  return step;
}

double sigmaOf(const numerics::PooledDeviation& deviation, double step) {
  return std::max(deviation.isKnown() ? std::sqrt(deviation.variance()) : 0.0, step / std::sqrt(12.0));
}

} // namespace

ReadingNoise readingNoise(const CampaignParts& parts, double fullScaleT) {
  ReadingNoise noise;
  numerics::PooledDeviation pt100;
  numerics::PooledDeviation electronics;
  std::vector<double> ohm;
  std::vector<double> degrees;
  for (const Axis axis : allAxes) {
    const StepRows& rows = parts.of(CampaignStep::Nonlinearity, axis);
    const AxisPlateaus plateaus = findPlateaus(rows, fullScaleT);
    numerics::PooledDeviation raw;
    for (const Plateau& plateau : plateaus.plateaus) {
      pool(rows.rawT.col(static_cast<Eigen::Index>(indexOf(axis))).segment(plateau.first, plateaus.rowsEach), raw);
      pool(rows.pt100Ohm.segment(plateau.first, plateaus.rowsEach), pt100);
      pool(rows.electronicsC.segment(plateau.first, plateaus.rowsEach), electronics);
    }
    noise.rawT[indexOf(axis)] = sigmaOf(raw, 0.0);
    ohm.insert(ohm.end(), rows.pt100Ohm.begin(), rows.pt100Ohm.end());
    degrees.insert(degrees.end(), rows.electronicsC.begin(), rows.electronicsC.end());
  }
  noise.pt100StepOhm = stepOf(std::move(ohm));
  noise.electronicsStepC = stepOf(std::move(degrees));
  noise.pt100Ohm = sigmaOf(pt100, noise.pt100StepOhm);
  noise.electronicsC = sigmaOf(electronics, noise.electronicsStepC);
  return noise;
}

} // namespace straightedge::field
