// The sensitivity vectors of the three axes against the package (Electronics 2020, 9, 151, section 7, Equations 2 and
// 3): B = S⁻¹·V, S by least squares over all orientations and fields.
#pragma once

#include "core/base/error.h"
#include "core/field/block_report.h"
#include "core/field/calibration.h"
#include "core/field/step_rows.h"

#include <Eigen/Core>

#include <array>
#include <string>
#include <vector>

namespace straightedge::field {

struct OrientationCoverage {
  Orientation orientation = Orientation::PlusX;
  std::size_t rows = 0;
  double smallestT = 0.0, largestT = 0.0; ///< reference along the package axis
};

struct AxisMatrixReport {
  BlockReport block; ///< residuals in tesla, all three components; covariance of S row by row (9 × 9)
  Eigen::Matrix3d matrix =
      Eigen::Matrix3d::Identity(); ///< S: rows are probe axes, columns package axes; not normalised
  Eigen::Matrix3d directions = Eigen::Matrix3d::Identity(); ///< rows of S at length 1: unit vectors of the probe axes
  std::array<double, 3> angleBetweenDeg = {90., 90., 90.};  ///< x and y, x and z, y and z
  std::array<double, 3> tiltDeg = {0., 0., 0.};             ///< of each probe axis against its package axis
  std::array<double, 3> gain = {1., 1., 1.};                ///< length of the rows
  double conditionNumber = 1.0;                             ///< of S
  std::vector<OrientationCoverage> coverage;                ///< all six, those without rows too
  std::vector<std::string> notes;                           ///< orientations that are missing, and what that costs
};

/// S from V5 of all three axes. `chain` holds the blocks before. A reference of a minus orientation may be signed along
/// the package axis (−x: −0.5 T, as the plan writes it) or along the field (−x: +0.5 T): the readings tell which.
/// Errors (Input): a package axis that never points along the field; readings that contradict the orientation (the
/// axis shows hardly anything, or another sign than in the other rows); a singular matrix.
Result<AxisMatrixReport> fitAxisMatrix(const StepRows& rows, const CorrectionChain& chain, const std::string& name);

} // namespace straightedge::field
