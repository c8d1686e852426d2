#include "core/angle/model.h"

#include "core/angle/angles.h"
#include "core/angle/harmonic_model.h"
#include "core/angle/linear_model.h"
#include "core/angle/lookup_table_model.h"
#include "core/angle/minimax_linear.h"
#include "core/angle/model_limits.h"
#include "core/angle/quantisation.h"
#include "core/angle/residual_errors.h"

#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <string>

namespace straightedge::angle {

namespace {

std::span<const double> spanOf(const Eigen::VectorXd& values) {
  return {values.data(), static_cast<std::size_t>(values.size())};
}

Result<HarmonicModel> fitHarmonics(const CorrectionCurve& curve, const ModelName& name) {
  if (name.size > curve.resolvableHarmonics) {
    const std::string resolved = std::to_string(curve.resolvableHarmonics);
    return fail(ErrorKind::Input,
                "model '" + name.text() + "' needs " + std::to_string(name.size) +
                    " harmonics, but the recorded angles resolve only " + resolved,
                "use harmonic:" + resolved + " at most, or record at least " + std::to_string(2 * name.size) +
                    " distinct angles");
  }
  const HarmonicSpectrum spectrum = spectrumOf(curve.gridDeg, curve.resolvableHarmonics);
  std::vector<int> orders;
  if (name.method == FitMethod::ByAmplitude) {
    orders = spectrum.ordersByAmplitude(curve.resolvableHarmonics);
    orders.resize(static_cast<std::size_t>(name.size));
  } else {
    orders.resize(static_cast<std::size_t>(name.size));
    std::iota(orders.begin(), orders.end(), 1);
  }
  return harmonicModelOf(spectrum, orders);
}

Result<LinearModel> fitLinear(const CorrectionCurve& curve, const ModelName& name) {
  if (name.method == FitMethod::OnCurve) {
    return LinearModel{curve.sampled(name.size)}; // node k lies at k·360/size
  }
  if (name.method == FitMethod::Minimax) {
    auto fit = linearMinimax(curve.gridDeg, name.size);
    if (!fit) {
      return std::unexpected(std::move(fit).error());
    }
    return LinearModel{std::move(fit->valuesDeg)};
  }
  return LinearModel{linearLeastSquares(curve.gridDeg, name.size)};
}

} // namespace

double Model::correctionDeg(double readingDeg) const {
  const double wrapped = wrap360(readingDeg);
  if (!std::isfinite(wrapped)) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  if (const auto* harmonics = std::get_if<HarmonicModel>(&body)) {
    return harmonicAt(*harmonics, wrapped);
  }
  if (const auto* linear = std::get_if<LinearModel>(&body)) {
    return linearAt(spanOf(linear->valuesDeg), wrapped);
  }
  return lookupTableAt(spanOf(std::get<LookupTableModel>(body).valuesDeg), wrapped);
}

Eigen::VectorXd Model::correctionOnGrid(int count) const {
  assert(count > 0);
  Eigen::VectorXd correction(count);
  if (const auto* harmonics = std::get_if<HarmonicModel>(&body)) {
    evaluateHarmonics(*harmonics, correction.data(), count);
  } else if (const auto* linear = std::get_if<LinearModel>(&body)) {
    evaluateLinear(spanOf(linear->valuesDeg), correction.data(), count);
  } else {
    evaluateLookupTable(spanOf(std::get<LookupTableModel>(body).valuesDeg), correction.data(), count);
  }
  return correction;
}

Result<Model> fitModel(const CorrectionCurve& curve, const ModelName& name) {
  if (const auto checked = checkedModelName(name); !checked) {
    return std::unexpected(checked.error());
  }
  Model model;
  model.name = name;
  if (name.kind == ModelKind::Harmonic) {
    auto harmonics = fitHarmonics(curve, name);
    if (!harmonics) {
      return std::unexpected(std::move(harmonics).error());
    }
    model.body = std::move(*harmonics);
  } else if (name.kind == ModelKind::Linear) {
    auto linear = fitLinear(curve, name);
    if (!linear) {
      return std::unexpected(std::move(linear).error());
    }
    model.body = std::move(*linear);
  } else {
    model.body = LookupTableModel{lookupTableValues(curve.gridDeg, name.size, name.method)};
  }
  if (name.bits) {
    auto [stored, body] = quantised(model.body, *name.bits);
    model.stored = std::move(stored);
    model.body = std::move(body);
  }
  const Eigen::VectorXd onGrid = model.correctionOnGrid();
  const ResidualErrors errors =
      residualErrors(onGrid.data(), curve.gridDeg.data(), static_cast<std::size_t>(onGrid.size()));
  model.errors.maxCurveDeg = errors.maxAbs;
  model.errors.rmsCurveDeg = errors.rms;
  return model;
}

void measurePoints(Model& model, const AlignedSweep& aligned) {
  double largest = 0.0;
  double sum = 0.0;
  const Eigen::Index count = aligned.readingDeg.size();
  for (Eigen::Index i = 0; i < count; ++i) {
    const double reading = aligned.readingDeg[i];
    const double error = wrap180(reading + model.correctionDeg(reading) - aligned.encoderDeg[i]);
    largest = std::max(largest, std::abs(error));
    sum += error * error;
  }
  model.errors.maxPointsDeg = largest;
  model.errors.rmsPointsDeg = count == 0 ? 0.0 : std::sqrt(sum / static_cast<double>(count));
}

double correctedDeg(const Model& model, SensorDirection direction, double sensorDeg) {
  const double reading = direction == SensorDirection::Decreasing ? wrap360(360.0 - sensorDeg) : wrap360(sensorDeg);
  return wrap360(reading + model.correctionDeg(reading));
}

} // namespace straightedge::angle
