// Sweep -> alignment: the recorded rows brought onto one turn of the sensor, with everything noticed on the way.
#pragma once

#include "core/angle/sweep.h"
#include "core/base/error.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace straightedge::angle {

enum class SensorDirection : std::int8_t { Increasing = 1, Decreasing = -1 };

/// Something the engineer should know though the work goes on. `text` is a whole sentence.
struct Warning {
  enum class Topic : std::uint8_t {
    FewAngles,
    FewAnglesForSwing,
    FewerPointsThanSegments,
    CoverageGap,
    SensorRunsBackwards,
    BeyondData,
    NoisyForModel,
    Other
  };
  Topic topic = Topic::Other;
  std::string text;
};

/// A stretch of sensor angle without any point, wider than twice the median distance and than 1°.
struct CoverageGap {
  double fromDeg = 0.0; ///< sensor angle of the last point before the gap, [0, 360)
  double widthDeg = 0.0;
};

/// What several passes over the same encoder angles tell. Degrees; absent where the sweep cannot tell.
struct Repeatability {
  std::optional<double> noiseDeg;         ///< standard deviation of readings at one angle, direction and turn
  std::optional<double> repeatabilityDeg; ///< standard deviation between turns of the per-angle, per-direction means,
                                          ///< apart from what noise leaves in them
  std::optional<double> hysteresisMaxDeg; ///< largest |half difference| between the directions' means
  std::optional<double> hysteresisRmsDeg;
  std::vector<double> encoderDeg;     ///< distinct encoder angles [0, 360), ascending, where both directions exist
  std::vector<double> risingMeanDeg;  ///< mean angle error reading − encoder there, rising direction
  std::vector<double> fallingMeanDeg; ///< the same, falling
  std::vector<double> hysteresisDeg;  ///< half the difference rising − falling, per encoder angle
  int turns = 1;
  bool bothDirections = false;
};

/// Rows used, sorted by reading. `readingDeg` is the sensor angle, or 360 − sensor for a decreasing sensor, in [0,
/// 360). `correctionDeg` = encoder − reading, continuous over the turn, mean in [−180, 180).
struct AlignedSweep {
  Eigen::VectorXd readingDeg;    ///< ascending
  Eigen::VectorXd correctionDeg; ///< same length
  Eigen::VectorXd encoderDeg;    ///< in [0, 360), same length
  std::vector<std::size_t> row;  ///< index into the sweep of each aligned point
  std::vector<int> turn;         ///< turn of each aligned point (recorded, or recovered from the encoder)
  std::vector<int> pass;         ///< +1 or −1: direction of travel of each aligned point
  SensorDirection direction = SensorDirection::Increasing;
  bool repeats = false;           ///< some readings occur more than once, or step back in encoder order
  std::size_t distinctAngles = 0; ///< distinct encoder angles on the circle
  double medianGapDeg = 0.0;
  double largestGapDeg = 0.0;
  std::vector<CoverageGap> gaps;
  Repeatability passes;
  std::vector<Warning> warnings;
};

/// Brings a sweep onto one turn.
/// Errors (kind Input, with the file and line where one row is to blame): fewer than 8 distinct angles; a gap of more
/// than 90° in coverage; a sensor that turns more or less than once per turn; a constant sensor; NaN or infinity;
/// sensor values outside [0, 360]. Source of the method: Allegro "Microcontroller-Based Linearization of Angular Sensor
/// ICs", Linearization Method 1–3.
Result<AlignedSweep> alignSweep(const Sweep& sweep);

} // namespace straightedge::angle
