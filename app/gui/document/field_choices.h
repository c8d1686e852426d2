// What the engineer chose for a field calibration.
#pragma once

#include "core/field/calibration.h"
#include "core/field/nonlinearity.h"
#include "core/field/verification.h"

#include <set>

namespace straightedge::gui {

/// Every change goes through the undo stack and into the session.
struct FieldChoices {
  int order = field::defaultOrder; ///< of the nonlinearity, field::lowestOrder to highestOrder
  field::FitMethod method = field::FitMethod::Stepwise;
  double fullScaleT = 2.0;
  double referenceTemperatureC = 24.0;
  std::set<field::Block> blocksOff; ///< switched off by choice: their rows count nowhere
  double limitPercent = 0.05;       ///< Verify
  field::PercentOf percentOf = field::PercentOf::FullScale;

  bool operator==(const FieldChoices&) const = default;
};

} // namespace straightedge::gui
