// Nonlinearity of one axis: reference field as a polynomial of the raw reading, from plateau means (Electronics 2020,
// 9, 151, section 5.1, Figures 5 and 6, Table 1).
#pragma once

#include "core/base/error.h"
#include "core/field/block_report.h"
#include "core/field/plateaus.h"

#include <string>
#include <vector>

namespace straightedge::field {

inline constexpr int lowestOrder = 1;
inline constexpr int highestOrder = 7;
inline constexpr int defaultOrder = 5;

/// One order of the comparison. Percent of full scale.
struct OrderResult {
  int order = 0;
  std::vector<double> coefficients; ///< ascending powers, tesla of raw tesla
  double maxErrorPercent = 0.0;
  double rmsErrorPercent = 0.0;
  double crossMaxPercent = 0.0; ///< every plateau foretold by a fit to the others (leave one out)
  double crossRmsPercent = 0.0; ///< infinite where a plateau alone decides a coefficient
  Eigen::VectorXd errorPercent; ///< instrument − reference at every plateau, for Figure 5
  Eigen::MatrixXd covariance;   ///< of the coefficients
  double residualSigmaT = 0.0;
};

struct NonlinearityReport {
  Axis axis = Axis::X;
  BlockReport block; ///< of the chosen order; residuals in tesla
  int order = defaultOrder;
  std::vector<double> coefficients; ///< of the chosen order, for AxisChain::nonlinearity
  double beforePercent = 0.0;       ///< largest |raw − reference|
  std::vector<OrderResult> orders;  ///< 1 to 7, as many as the plateaus determine
  int bestCrossValidated = 0;       ///< order with the least cross-validated rms
  std::string explanation;          ///< why the chosen order will do, and what its neighbours would give
  AxisPlateaus plateaus;            ///< what it was fitted to
};

struct NonlinearityOptions {
  int order = defaultOrder;
  double fullScaleT = 2.0;
};

/// Errors (Input, where = `name` and line): fewer plateaus than the order needs (order + 2); a reference that was
/// never locked; fields of one sign only; readings that contradict the reference (opposite sign, two plateaus of one
/// field far apart, no response).
Result<NonlinearityReport> fitNonlinearity(const AxisPlateaus& plateaus, const NonlinearityOptions& options,
                                           const std::string& name);

} // namespace straightedge::field
