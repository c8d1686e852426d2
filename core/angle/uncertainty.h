// Uncertainty of a corrected angle (GUM, JCGM 100:2008, sections 4.3, 5.1.2, 6.2): standard contributions, combined,
// expanded to 95 %.
#pragma once

#include "core/angle/model.h"

#include <string>
#include <vector>

namespace straightedge::angle {

struct UncertaintyContribution {
  std::string name; ///< "repeatability", "noise", "hysteresis", "reference", "quantisation", "model residual", …
  double standardDeg = 0.0; ///< standard uncertainty, degrees
  std::string basis;        ///< how it was obtained: distribution and divisor
};

struct UncertaintyBudget {
  std::string model; ///< model name it is for
  std::vector<UncertaintyContribution> contributions;
  double combinedDeg = 0.0;
  double coverageFactor = 2.0;
  double expandedDeg = 0.0; ///< 95 %
};

struct UncertaintyInputs {
  double referenceExpandedDeg = 0.0; ///< the reference's stated expanded uncertainty (k = 2)
  double sensorResolutionDeg = 0.0;  ///< one step of the sensor's output; 0 = estimated from the data
};

UncertaintyBudget uncertaintyOf(const Model& model, const AlignedSweep& aligned, const CorrectionCurve& curve,
                                const UncertaintyInputs& inputs);

} // namespace straightedge::angle
