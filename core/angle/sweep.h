// A sweep as recorded: sensor angle against encoder angle, row by row, nothing computed yet.
#pragma once

#include "core/base/traceability.h"

#include <cstddef>
#include <string>
#include <vector>

namespace straightedge::angle {

/// Columns of equal length; an optional column is empty where it was not recorded.
/// Encoder angles in degrees, any order, any start, may exceed 360 over several turns.
/// Sensor angles in degrees in [0, 360] (360 reads as 0).
struct Sweep {
  std::vector<double> encoderDeg;
  std::vector<double> sensorDeg;
  std::vector<int> turn;            ///< optional: 0, 1, …
  std::vector<int> direction;       ///< optional: +1 encoder rising, −1 falling
  std::vector<double> temperatureC; ///< optional
  std::vector<double> timeS;        ///< optional, seconds since the sweep's start
  std::vector<bool> enabled;        ///< optional: empty = all; false = switched off in Review
  std::vector<std::size_t> line;    ///< optional: line of each row in the file it was read from (1-based), for messages
  SourceRecord source;

  std::size_t size() const { return encoderDeg.size(); }
  bool isEnabled(std::size_t row) const { return enabled.empty() || enabled[row]; }
};

} // namespace straightedge::angle
