#include "core/field/axis_matrix.h"

#include "core/field/chain_stages.h"
#include "core/field/messages.h"
#include "core/field/names.h"
#include "core/field/residuals.h"
#include "core/field/span_checks.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace straightedge::field {

namespace {

/// An axis more than 60° off its package axis has not been turned as the orientation says.
constexpr double leastResponse = 0.5;
/// Rows below this share of the largest field do not decide about signs.
constexpr double rowDecidesSign = 0.05;
/// Two axes within about half a degree of each other, or one that is dead.
constexpr double largestCondition = 100.0;

using Columns = Eigen::Matrix<double, Eigen::Dynamic, 3>;

std::string orientationText(Orientation orientation) { return std::string(orientationName(orientation)); }

/// +1 where the reference is signed along the package axis, −1 where along the field.
double signOf(const StepRows& rows, const Columns& values, Orientation orientation) {
  const auto axis = static_cast<Eigen::Index>(indexOf(axisOf(orientation)));
  double together = 0.0;
  for (Eigen::Index i = 0; i < rows.size(); ++i) {
    if (rows.orientation[static_cast<std::size_t>(i)] == orientation) {
      together += values(i, axis) * rows.referenceT[i];
    }
  }
  return isMinus(orientation) && together < 0.0 ? -1.0 : 1.0;
}

Result<Columns> fieldsOf(const StepRows& rows, const Columns& values, const std::string& name) {
  std::array<double, 6> signs{};
  for (const Orientation orientation : allOrientations) {
    signs[static_cast<std::size_t>(orientation)] = signOf(rows, values, orientation);
  }
  const double certainT = rowDecidesSign * rows.referenceT.cwiseAbs().maxCoeff();
  Columns fields = Columns::Zero(rows.size(), 3);
  for (Eigen::Index i = 0; i < rows.size(); ++i) {
    const Orientation orientation = rows.orientation[static_cast<std::size_t>(i)];
    const auto axis = static_cast<Eigen::Index>(indexOf(axisOf(orientation)));
    const double alongT = signs[static_cast<std::size_t>(orientation)] * rows.referenceT[i];
    fields(i, axis) = alongT;
    if (std::abs(alongT) < certainT) {
      continue;
    }
    const double response = values(i, axis) / alongT;
    if (response < leastResponse) {
      return campaignFault(name, rows.line[static_cast<std::size_t>(i)],
                           "axis " + std::string(axisName(axisOf(orientation))) + " reads " +
                               teslaText(values(i, axis)) + " in the orientation " + orientationText(orientation) +
                               " and a field of " + teslaText(rows.referenceT[i]) +
                               (response < 0.0 ? ": the signs contradict the other rows" : ""),
                           "check orientation and sign of the reference in this row");
    }
  }
  return fields;
}

Result<void> cover(const StepRows& rows, const std::string& name, AxisMatrixReport& report) {
  for (const Orientation orientation : allOrientations) {
    OrientationCoverage coverage{.orientation = orientation};
    for (Eigen::Index i = 0; i < rows.size(); ++i) {
      if (rows.orientation[static_cast<std::size_t>(i)] == orientation) {
        const double field = rows.referenceT[i];
        coverage.smallestT = coverage.rows == 0 ? field : std::min(coverage.smallestT, field);
        coverage.largestT = coverage.rows == 0 ? field : std::max(coverage.largestT, field);
        ++coverage.rows;
      }
    }
    report.coverage.push_back(coverage);
  }
  for (const Axis axis : allAxes) {
    const OrientationCoverage& plus = report.coverage[2 * indexOf(axis)];
    const OrientationCoverage& minus = report.coverage[2 * indexOf(axis) + 1];
    const std::string word(axisName(axis));
    if (plus.rows + minus.rows == 0) {
      return campaignFault(name, 0,
                           "the step orientation has no row with the package's " + word +
                               " along the field: neither +" + word + " nor -" + word,
                           "record this orientation, too");
    }
    if (plus.rows == 0 || minus.rows == 0) {
      const std::string missing = (plus.rows == 0 ? "+" : "-") + word;
      report.notes.push_back("The orientation " + missing +
                             " is missing: an offset that the other blocks leave goes into the axis matrix.");
    }
  }
  return {};
}

void describe(AxisMatrixReport& report) {
  constexpr double degrees = 180.0 / std::numbers::pi;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double length = report.matrix.row(i).norm();
    report.gain[static_cast<std::size_t>(i)] = length;
    report.directions.row(i) = report.matrix.row(i) / length;
  }
  const auto angle = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return degrees * std::atan2(a.cross(b).norm(), a.dot(b));
  };
  const Eigen::Matrix3d& unit = report.directions;
  report.angleBetweenDeg = {angle(unit.row(0), unit.row(1)), angle(unit.row(0), unit.row(2)),
                            angle(unit.row(1), unit.row(2))};
  for (Eigen::Index i = 0; i < 3; ++i) {
    report.tiltDeg[static_cast<std::size_t>(i)] = angle(unit.row(i), Eigen::Vector3d::Unit(i));
  }
}

Result<void> solve(const Columns& fields, const Columns& values, const std::string& name, AxisMatrixReport& report) {
  const Eigen::Matrix3d normal = fields.transpose() * fields;
  const Eigen::Matrix3d spread = normal.inverse();
  report.matrix = (spread * (fields.transpose() * values)).transpose();
  const Columns residuals = values - fields * report.matrix.transpose();
  const Eigen::Index rows = fields.rows();
  report.block.covariance = Eigen::MatrixXd::Zero(9, 9);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double variance = rows > 3 ? residuals.col(axis).squaredNorm() / static_cast<double>(rows - 3) : 0.0;
    report.block.covariance.block<3, 3>(3 * axis, 3 * axis) = variance * spread;
  }
  report.block.residuals = residualsOf(residuals.reshaped(), 9);
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(report.matrix);
  const auto& singular = svd.singularValues();
  report.conditionNumber = singular[2] > 0.0 ? singular[0] / singular[2] : std::numeric_limits<double>::infinity();
  if (!report.matrix.allFinite() || !(report.conditionNumber <= largestCondition)) {
    return campaignFault(name, 0,
                         "the axis matrix is singular (condition number " + formatForPeople(report.conditionNumber, 3) +
                             "): two axes of the probe read the same field, or one reads none",
                         "check the probe's axes and the rows of the step orientation");
  }
  return {};
}

} // namespace

Result<AxisMatrixReport> fitAxisMatrix(const StepRows& rows, const CorrectionChain& chain, const std::string& name) {
  if (auto enough = checkRowCount(rows, name); !enough) {
    return std::unexpected(std::move(enough.error()));
  }
  AxisMatrixReport report;
  if (auto covered = cover(rows, name, report); !covered) {
    return std::unexpected(std::move(covered.error()));
  }
  Columns values(rows.size(), 3);
  for (const Axis axis : allAxes) {
    values.col(static_cast<Eigen::Index>(indexOf(axis))) =
        axisValuesT(chain, axis, rows, ChainStage::ElectronicsSensitivity);
  }
  const auto fields = fieldsOf(rows, values, name);
  if (!fields) {
    return std::unexpected(fields.error());
  }
  if (auto solved = solve(*fields, values, name, report); !solved) {
    return std::unexpected(std::move(solved.error()));
  }
  describe(report);
  report.block.rows = rowsOf(rows);
  report.block.how = "least squares over " + counted(report.block.rows.used, "row") +
                     " of all orientations and fields up to " + teslaText(rows.referenceT.cwiseAbs().maxCoeff());
  return report;
}

} // namespace straightedge::field
