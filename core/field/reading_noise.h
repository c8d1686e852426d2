// How a single reading scatters while nothing changes: raw readings and both temperatures, from the rows of the
// plateaus.
#pragma once

#include "core/field/step_rows.h"

#include <array>

namespace straightedge::field {

struct ReadingNoise {
  std::array<double, 3> rawT = {0.0, 0.0, 0.0}; ///< standard deviation of a raw reading, of each axis in its own field
  double pt100Ohm = 0.0;
  double electronicsC = 0.0;
  // The steps that the values come in count as rectangular where they are coarser than the scatter shows
  double pt100StepOhm = 0.0;
  double electronicsStepC = 0.0;
};

/// Pooled over plateaus; the scatter of a temperature is at least its step/√12.
ReadingNoise readingNoise(const CampaignParts& parts, double fullScaleT);

} // namespace straightedge::field
