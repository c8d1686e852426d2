// Readings at one locked field, averaged: what the nonlinearity is fitted to.
#pragma once

#include "core/field/step_rows.h"

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <vector>

namespace straightedge::field {

struct Plateau {
  double referenceT = 0.0;      ///< mean over the rows kept
  double referenceSigmaT = 0.0; ///< standard deviation over the rows kept; 0 of a single row
  Eigen::Vector3d rawT = Eigen::Vector3d::Zero();
  Eigen::Vector3d rawSigmaT = Eigen::Vector3d::Zero();
  double probeOhm = 0.0;     ///< mean PT100; NaN where not recorded
  double electronicsC = 0.0; ///< mean; NaN where not recorded
  Eigen::Index first = 0;    ///< row in the step's rows
  Eigen::Index recorded = 0; ///< locked rows of the run, before cutting
  std::int64_t line = 0;     ///< of its first row; 0 where there is no file
};

struct RejectedPlateau {
  double referenceT = 0.0;
  Eigen::Index rows = 0;
  std::int64_t line = 0;
  std::string reason; ///< "only 2 rows where the others have 9", "the reference moves by 3.1 mT", …
};

struct AxisPlateaus {
  Axis axis = Axis::X;
  std::vector<Plateau> plateaus;
  std::vector<RejectedPlateau> rejected;
  Eigen::Index rowsEach = 0; ///< every plateau is cut to the shortest; its first rows are kept
  std::size_t unlocked = 0;  ///< rows left out: reference not locked
  std::size_t unsettled = 0; ///< rows of rejected plateaus
  std::size_t surplus = 0;   ///< rows cut off
  std::size_t incomplete = 0;

  Eigen::VectorXd referenceT() const; ///< means, one per plateau
  Eigen::VectorXd rawT(Axis of) const;
  double noiseT(Axis of) const; ///< standard deviation of a single reading, pooled over the plateaus
};

/// The runs of `rows` (of a step with axis and reference) as plateaus of equal length.
/// Rejected are runs that are far shorter than the others (fewer than 3 rows where half of the runs have more than
/// that), and unsettled ones: reference or reading scatters over 20 times as much as in the median plateau, and over
/// 1e-5 of full scale. They do not shorten the others.
AxisPlateaus findPlateaus(const StepRows& rows, double fullScaleT);

} // namespace straightedge::field
