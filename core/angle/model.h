// One way of storing a correction curve, and what it does to a reading.
#pragma once

#include "core/angle/curve.h"
#include "core/angle/model_name.h"

#include <Eigen/Core>

#include <optional>
#include <variant>
#include <vector>

namespace straightedge::angle {

struct HarmonicTerm {
  int order = 1;
  double amplitudeDeg = 0.0;
  double phaseRad = 0.0; ///< in (−π, π]; the term is amplitude·cos(order·x + phase)
};
struct HarmonicModel {
  double offsetDeg = 0.0;          ///< keeps its sign
  std::vector<HarmonicTerm> terms; ///< in the order chosen
};
/// Values at k·360/n; linear between them; the value at 360° is the first again.
struct LinearModel {
  Eigen::VectorXd valuesDeg;
};
/// Entry k serves k·360/n ≤ x < (k+1)·360/n.
struct LookupTableModel {
  Eigen::VectorXd valuesDeg;
};

/// How a quantised model is stored: value = bias + lsb · integer. Harmonics: amplitudes then phases.
struct StoredIntegers {
  int bits = 16;
  double lsbDeg = 0.0;
  double biasDeg = 0.0;
  std::optional<double> phaseLsbRad;
  std::vector<int> integers;
};

/// Errors of a model in degrees, as calibration.json states them.
struct ModelErrors {
  double maxCurveDeg = 0.0; ///< against the 4096-point curve
  double rmsCurveDeg = 0.0;
  double maxPointsDeg = 0.0; ///< against the recorded points, wrapped to [−180, 180)
  double rmsPointsDeg = 0.0;
};

struct Model {
  ModelName name;
  std::variant<HarmonicModel, LinearModel, LookupTableModel>
      body; ///< of a quantised model: the values its integers stand for
  std::optional<StoredIntegers> stored;
  ModelErrors errors;

  /// Correction in degrees for a reading in degrees (any finite angle; exactly 360 is 0).
  double correctionDeg(double readingDeg) const;
  /// Correction at i·360/count. Bins by integers, ⌊i·size/count⌋, as in the seed.
  Eigen::VectorXd correctionOnGrid(int count = gridSize) const;
};

/// Fits one model to a curve. `errors` is filled for the curve; points errors need measurePoints().
/// Errors (kind Input): more harmonics than the points resolve. (kind Usage): size out of range.
Result<Model> fitModel(const CorrectionCurve& curve, const ModelName& name);

/// Fills the points part of `model.errors` from the aligned points.
void measurePoints(Model& model, const AlignedSweep& aligned);

/// corrected = wrap360(reading' + correction(reading')), reading' = reading or 360 − reading.
double correctedDeg(const Model& model, SensorDirection direction, double sensorDeg);

} // namespace straightedge::angle
