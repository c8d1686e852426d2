#include "tests/core/angle/model_curves.h"

#include "core/angle/sweep_csv.h"

#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

namespace straightedge::angle {

namespace {

template <typename T>
T valueOrThrow(Result<T> result) {
  if (!result) {
    throw std::runtime_error(result.error().message());
  }
  return std::move(*result);
}

} // namespace

std::string angleData(const std::string& name) { return std::string(STRAIGHTEDGE_TEST_DATA) + "/angle/" + name; }

const AlignedSweep& sideShaftAligned() {
  static const AlignedSweep aligned =
      valueOrThrow(alignSweep(valueOrThrow(readSweepCsv(angleData("side_shaft_32.csv")))));
  return aligned;
}

const CorrectionCurve& sideShaftCurve() {
  static const CorrectionCurve curve = valueOrThrow(fitCurve(sideShaftAligned()));
  return curve;
}

const CorrectionCurve& studiedCurve() {
  static const CorrectionCurve curve = [] {
    CorrectionCurve copy = sideShaftCurve();
    copy.resolvableHarmonics = 64;
    return copy;
  }();
  return curve;
}

CorrectionCurve curveOfWaves(double offsetDeg, const std::vector<Wave>& waves) {
  CorrectionCurve curve;
  curve.method = CurveMethod::Regress;
  curve.resolvableHarmonics = 64;
  curve.trigonometric.offsetDeg = offsetDeg;
  curve.trigonometric.cosine = Eigen::VectorXd::Zero(64);
  curve.trigonometric.sine = Eigen::VectorXd::Zero(64);
  for (const Wave& wave : waves) {
    curve.trigonometric.cosine[wave.order - 1] += wave.amplitudeDeg * std::cos(wave.phaseRad);
    curve.trigonometric.sine[wave.order - 1] -= wave.amplitudeDeg * std::sin(wave.phaseRad);
  }
  curve.gridDeg = curve.sampled(gridSize);
  return curve;
}

CorrectionCurve curveOfGrid(const Eigen::VectorXd& gridDeg) {
  CorrectionCurve curve;
  curve.gridDeg = gridDeg;
  curve.resolvableHarmonics = 64;
  return curve;
}

Eigen::VectorXd roughGrid(std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  Eigen::VectorXd grid = Eigen::VectorXd::Constant(gridSize, 100.0 * uniform(random));
  for (int order = 1; order <= 12; ++order) {
    const double amplitude = 10.0 * uniform(random) / (order * order);
    const double phase = std::numbers::pi * uniform(random);
    for (Eigen::Index i = 0; i < gridSize; ++i) {
      grid[i] += amplitude * std::cos(2.0 * std::numbers::pi * order * static_cast<double>(i) / gridSize + phase);
    }
  }
  const double noise = (seed % 4) * 0.1;
  const int stepAt = static_cast<int>(random() % gridSize);
  for (Eigen::Index i = 0; i < gridSize; ++i) {
    grid[i] += noise * uniform(random) + (seed % 3 == 2 && i >= stepAt ? 3.0 : 0.0);
  }
  if (seed % 5 == 4) {
    grid[static_cast<Eigen::Index>(random() % gridSize)] += 20.0;
  }
  return grid;
}

} // namespace straightedge::angle
