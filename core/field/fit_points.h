// All rows of a campaign, of every step, as points that one axis's whole chain is fitted to.
#pragma once

#include "core/field/calibration.h"
#include "core/field/step_rows.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace straightedge::field {

/// Rows of one run at nearly one temperature, as their means. That is equivalent to the single rows: within half a
/// degree the chain is a plane in reading and temperatures to a part in 10⁷ of full scale.
struct FitPoint {
  CampaignStep step = CampaignStep::Nonlinearity;
  double rawT = 0.0;
  double probeC = 0.0;                              ///< minus reference temperature; 0 where not recorded
  double electronicsC = 0.0;                        ///< minus reference temperature; 0 where not recorded
  double targetT = 0.0;                             ///< what V5 should be; of orientations, see fieldT
  Eigen::Vector3d fieldT = Eigen::Vector3d::Zero(); ///< of orientations: the field against the package; V5 should be
                                                    ///< the axis's row of S times it
  std::size_t rows = 0;
  std::size_t run = 0;    ///< points of one run were taken at one setting of the field
  double scatterT2 = 0.0; ///< Σ (V5 − reference − mean of these)² over the rows, through the chain given
};

struct FitPoints {
  std::array<std::vector<FitPoint>, 3> axes; ///< x, y, z
};

/// `chain`: the PT100's line and, for the scatter, a first set of coefficients. Nonlinearity: the plateaus of
/// findPlateaus(). Steps without rows give no points.
FitPoints fitPoints(const CampaignParts& parts, const CorrectionChain& chain);

} // namespace straightedge::field
