#include "core/field/sensitivity.h"

#include "core/field/chain_stages.h"
#include "core/field/field_sweeps.h"
#include "core/field/messages.h"
#include "core/field/names.h"
#include "core/field/residuals.h"
#include "core/numerics/polynomial.h"
#include "core/numerics/statistics.h"

#include <algorithm>
#include <cmath>

namespace straightedge::field {

using numerics::PolynomialFit;

namespace {

constexpr int interceptOrder = 1;

/// Variances of the sweeps' values; enlarged (Birge) where the values scatter about the polynomial more than their own
/// noise explains, which noise alone would not show.
Eigen::VectorXd variances(const PolynomialFit& fit, const Eigen::VectorXd& sigma) {
  Eigen::VectorXd result = sigma.cwiseAbs2();
  if (fit.freedom() > 0) {
    const double chiSquare = (fit.residuals.array().square() / result.array().max(1e-300)).sum();
    const double excess = chiSquare / static_cast<double>(fit.freedom());
    result *= std::max(1.0, excess);
  }
  return result;
}

std::string rangeText(const std::vector<FieldSweep>& sweeps) {
  const auto [least, most] = std::ranges::minmax(sweeps, {}, &FieldSweep::referenceT);
  return counted(sweeps.size(), "temperature sweep") + " at fields from " + teslaText(least.referenceT) + " to " +
         teslaText(most.referenceT);
}

BlockRows rowsUsed(const StepRows& rows, const std::vector<FieldSweep>& sweeps) {
  BlockRows result = rowsOf(rows);
  std::size_t used = 0;
  for (const FieldSweep& sweep : sweeps) {
    used += static_cast<std::size_t>(sweep.rows);
  }
  result.unsettled = result.used - used;
  result.used = used;
  return result;
}

std::vector<double> asVector(const Eigen::VectorXd& values) { return {values.begin(), values.end()}; }

std::vector<SlopeOrder> compareOrders(const Eigen::VectorXd& field, const Eigen::VectorXd& slope) {
  std::vector<SlopeOrder> orders;
  for (int order = 1; order < field.size(); ++order) {
    const auto fit = numerics::fitPolynomial(field, slope, order);
    if (!fit) {
      break;
    }
    orders.push_back({order, asVector(fit->coefficients), numerics::rootMeanSquare(fit->residuals),
                      numerics::largestMagnitude(fit->residuals)});
  }
  return orders;
}

/// Of the slope's coefficients, then the intercept's; a sweep's slope and intercept go together.
Eigen::MatrixXd jointCovariance(const PolynomialFit& slope, const PolynomialFit& intercept,
                                const std::vector<FieldSweep>& sweeps) {
  const Eigen::VectorXd slopeVariance = variances(slope, valuesOf(sweeps, &FieldSweep::slopeSigma));
  const Eigen::VectorXd interceptVariance = variances(intercept, valuesOf(sweeps, &FieldSweep::interceptSigma));
  const Eigen::VectorXd mixed = valuesOf(sweeps, &FieldSweep::covariance);
  const Eigen::Index k = slope.coefficients.size();
  const Eigen::Index c = intercept.coefficients.size();
  Eigen::MatrixXd covariance(k + c, k + c);
  covariance.topLeftCorner(k, k) = slope.influence * slopeVariance.asDiagonal() * slope.influence.transpose();
  covariance.bottomRightCorner(c, c) =
      intercept.influence * interceptVariance.asDiagonal() * intercept.influence.transpose();
  covariance.topRightCorner(k, c) = slope.influence * mixed.asDiagonal() * intercept.influence.transpose();
  covariance.bottomLeftCorner(c, k) = covariance.topRightCorner(k, c).transpose();
  return covariance;
}

std::unexpected<Error> undetermined(const StepRows& rows, const std::string& name) {
  return campaignFault(name, 0,
                       "the fields of the step " + std::string(stepName(rows.step)) +
                           " do not determine how the sensitivity depends on them",
                       "record the step at fields spread over the range");
}

} // namespace

Result<SensitivityReport> fitSensitivity(const StepRows& rows, const CorrectionChain& chain, Axis axis,
                                         const std::string& name) {
  const SweepInputs inputs{rows, axisValuesT(chain, axis, rows, ChainStage::Offset), probeTemperatureC(chain, rows),
                           "probe"};
  auto sweeps = sweepsOf(inputs, name);
  if (!sweeps) {
    return std::unexpected(std::move(sweeps.error()));
  }
  SensitivityReport report;
  report.axis = axis;
  const int fields = distinctFields(*sweeps);
  const int order = fields > highestSlopeOrder ? highestSlopeOrder : 1;
  if (order < highestSlopeOrder) {
    report.note = "Axis " + std::string(axisName(axis)) + ": only " + std::to_string(fields) +
                  " fields in the step sensitivity: its slope over the field is a line instead of a cubic.";
  }
  const Eigen::VectorXd field = valuesOf(*sweeps, &FieldSweep::valueT);
  const Eigen::VectorXd slopes = valuesOf(*sweeps, &FieldSweep::slope);
  const auto slope = numerics::fitPolynomial(field, slopes, order);
  const auto intercept = numerics::fitPolynomial(field, valuesOf(*sweeps, &FieldSweep::intercept), interceptOrder);
  if (!slope || !intercept) {
    return undetermined(rows, name);
  }
  report.slope = asVector(slope->coefficients);
  report.intercept = asVector(intercept->coefficients);
  report.slopeOrders = compareOrders(field, slopes);
  report.block.covariance = jointCovariance(*slope, *intercept, *sweeps);

  const Eigen::VectorXd after =
      inputs.valueT.array() -
      numerics::polynomialAt(report.slope, inputs.valueT).array() * inputs.temperatureC.array() -
      numerics::polynomialAt(report.intercept, inputs.valueT).array();
  const Eigen::VectorXd errors = errorsAfter(inputs, after, *sweeps);
  report.block.residuals = residualsOf(errors, slope->coefficients.size() + intercept->coefficients.size());
  report.block.rows = rowsUsed(rows, *sweeps);
  report.block.how = "lines of the error over the probe's temperature in " + rangeText(*sweeps) +
                     "; their slopes as a polynomial of order " + std::to_string(order) +
                     " over the field, their intercepts as one of order 1";
  report.sweeps = std::move(*sweeps);
  return report;
}

Result<ElectronicsSensitivityReport> fitElectronicsSensitivity(const StepRows& rows, const CorrectionChain& chain,
                                                               Axis axis, const std::string& name) {
  const SweepInputs inputs{rows, axisValuesT(chain, axis, rows, ChainStage::Electronics),
                           electronicsTemperatureC(chain, rows), "electronics"};
  auto sweeps = sweepsOf(inputs, name);
  if (!sweeps) {
    return std::unexpected(std::move(sweeps.error()));
  }
  const auto line = numerics::fitPolynomial(valuesOf(*sweeps, &FieldSweep::valueT),
                                            valuesOf(*sweeps, &FieldSweep::slope), interceptOrder);
  if (!line) {
    return undetermined(rows, name);
  }
  ElectronicsSensitivityReport report;
  report.axis = axis;
  report.coefficients = {line->coefficients[0], line->coefficients[1]};
  const Eigen::VectorXd variance = variances(*line, valuesOf(*sweeps, &FieldSweep::slopeSigma));
  report.block.covariance = line->influence * variance.asDiagonal() * line->influence.transpose();
  const Eigen::VectorXd after =
      inputs.valueT.array() -
      numerics::polynomialAt(report.coefficients, inputs.valueT).array() * inputs.temperatureC.array();
  report.block.residuals = residualsOf(errorsAfter(inputs, after, *sweeps), 2);
  report.block.rows = rowsUsed(rows, *sweeps);
  report.block.how =
      "slopes of the error over the electronics' temperature in " + rangeText(*sweeps) + ", as a line over the field";
  report.sweeps = std::move(*sweeps);
  return report;
}

} // namespace straightedge::field
