// Alignment -> correction curve: what has to be added to a reading, over one turn of the sensor.
#pragma once

#include "core/angle/alignment.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <vector>

namespace straightedge::angle {

/// Grid on which curves live: sensor angle i·360/4096 (as in the seed's projection).
inline constexpr int gridSize = 4096;
/// Finer grid on which large tables are judged; the coarse one flatters them.
inline constexpr int fineGridSize = 65536;

enum class CurveMethod : std::uint8_t { Auto, Interpolate, Regress };

struct CurveOptions {
  CurveMethod method = CurveMethod::Auto;
};

/// Continuous, periodic correction over the reading (sensor angle, or 360 − sensor for a decreasing one).
class CorrectionCurve {
public:
  /// Periodic cubic spline; knots ascending in [0, 360), values in degrees, second derivatives per degree².
  struct Spline {
    Eigen::VectorXd knotDeg, valueDeg, secondDerivative;
  };
  /// offset + Σ cosine[k−1]·cos(k·x) + sine[k−1]·sin(k·x), degrees.
  struct Trigonometric {
    double offsetDeg = 0.0;
    Eigen::VectorXd cosine, sine;
  };

  CurveMethod method = CurveMethod::Interpolate; ///< the one used; never Auto
  Spline spline;                                 ///< filled when interpolated
  Trigonometric trigonometric;                   ///< filled when regressed
  Eigen::VectorXd gridDeg;                       ///< correction at i·360/4096, mean in [−180, 180)
  double leaveOneOutRmsDeg = 0.0;                ///< how well each point is foretold by the others
  double leaveOneOutMaxDeg = 0.0;
  std::optional<double>
      residualSigmaDeg; ///< regression: standard deviation of the points about the curve (degrees of freedom counted)
  int harmonics = 0;    ///< regression: number of harmonics, chosen by cross-validation
  std::vector<double> crossValidationRmsDeg; ///< regression: leave-one-out rms for 0, 1, 2, … harmonics
  int resolvableHarmonics = 0;               ///< min(64, half the number of distinct points): more are refused

  double at(double readingDeg) const;       ///< correction in degrees; any finite angle
  Eigen::VectorXd sampled(int count) const; ///< correction at i·360/count
};

/// Errors: none beyond those of alignment, except Input where interpolation is asked for of readings that repeat.
Result<CorrectionCurve> fitCurve(const AlignedSweep& aligned, const CurveOptions& options = {});

} // namespace straightedge::angle
