// What a certificate says about the uncertainty of a field calibration: figures over field and temperature.
#pragma once

#include "core/base/error.h"

#include <string>
#include <vector>

namespace straightedge::field {

struct UncertaintyShare {
  std::string name;      ///< "repeatability", "probe temperature", …
  double largestT = 0.0; ///< standard uncertainty where it is largest; of the chain's residual its magnitude
  std::string basis;     ///< how it was obtained
};

/// One point of the grid: field along one axis of the package.
struct UncertaintyAt {
  int axis = 0; ///< 0 x, 1 y, 2 z: the axis that the field lies along, and whose component this is about
  double fieldT = 0.0;
  double probeC = 0.0;
  double electronicsC = 0.0;
  double expandedT = 0.0;
};

/// For one reading and each component by itself, 95 %; see uncertainty.h.
struct UncertaintySummary {
  double probability = 0.95;
  double largestT = 0.0; ///< expanded, over the grid
  double medianT = 0.0;
  double referenceRelative = 0.0; ///< standard
  std::vector<UncertaintyShare> shares;
  std::vector<UncertaintyAt> grid;
};

class FieldUncertainty;
struct FieldRun;

/// Over the whole scale along each axis, at the reference temperatures and at the ends of those that the campaign
/// covers.
UncertaintySummary summaryOf(const FieldUncertainty& uncertainty);

/// Of a run's chain, with what its traceability says of the reference: an expanded uncertainty (k = 2) in tesla, taken
/// to hold at full scale and to be proportional to the field. Takes some ten milliseconds.
/// Errors: those of FieldUncertainty::of().
Result<UncertaintySummary> uncertaintyOf(const FieldRun& run);

} // namespace straightedge::field
