#include "core/field/zero_field_line.h"

#include "core/field/chain_stages.h"
#include "core/field/messages.h"
#include "core/field/names.h"
#include "core/field/residuals.h"
#include "core/field/span_checks.h"
#include "core/numerics/polynomial.h"

namespace straightedge::field {

namespace {

/// More is no zero-field chamber, of full scale.
constexpr double largestZeroField = 0.02;

struct Quantity {
  std::string_view thing; ///< whose temperature
  std::string_view value; ///< what the line goes through
};

Result<ZeroFieldReport> fitLine(const StepRows& rows, const CorrectionChain& chain, Axis axis,
                                const Eigen::VectorXd& temperatureC, ChainStage before, const Quantity& quantity,
                                const std::string& name) {
  const std::string step(stepName(rows.step));
  if (auto enough = checkRowCount(rows, name); !enough) {
    return std::unexpected(std::move(enough.error()));
  }
  if (auto moves = checkSpan(temperatureC, std::string(quantity.thing), step, name); !moves) {
    return std::unexpected(std::move(moves.error()));
  }
  ZeroFieldReport report;
  report.axis = axis;
  report.temperatureC = temperatureC;
  report.valueT = axisValuesT(chain, axis, rows, before);
  report.spanC = temperatureC.maxCoeff() - temperatureC.minCoeff();
  Eigen::Index worst = 0;
  const double largestT = report.valueT.cwiseAbs().maxCoeff(&worst);
  if (largestT > largestZeroField * chain.fullScaleT) {
    return campaignFault(name, rows.line[static_cast<std::size_t>(worst)],
                         "axis " + std::string(axisName(axis)) + " reads " + teslaText(report.valueT[worst]) +
                             " in the step " + step + ", which belongs into a zero-field chamber",
                         "record the step again in the chamber, or remove the row");
  }
  const auto fit =
      numerics::fitPolynomial(temperatureC, report.valueT, 1, numerics::PolynomialDetail::WithoutInfluence);
  if (!fit) {
    return campaignFault(name, 0, "the rows of the step " + step + " do not determine a line", "record it again");
  }
  report.offsetT = {fit->coefficients[0], fit->coefficients[1]};
  report.block.covariance = fit->covariance;
  report.block.residuals = residualsOf(fit->residuals, 2);
  report.block.rows = rowsOf(rows);
  report.block.how = "line through " + counted(report.block.rows.used, "row") + " of " + std::string(quantity.value) +
                     " over the temperature of the " + std::string(quantity.thing) + ", which covers " +
                     celsiusText(report.spanC);
  return report;
}

} // namespace

Result<ZeroFieldReport> fitTemperatureOffset(const StepRows& rows, const CorrectionChain& chain, Axis axis,
                                             const std::string& name) {
  return fitLine(rows, chain, axis, probeTemperatureC(chain, rows), ChainStage::Nonlinearity,
                 {"probe", "the linearised reading"}, name);
}

Result<ZeroFieldReport> fitElectronicsOffset(const StepRows& rows, const CorrectionChain& chain, Axis axis,
                                             const std::string& name) {
  return fitLine(rows, chain, axis, electronicsTemperatureC(chain, rows), ChainStage::Sensitivity,
                 {"electronics", "the reading corrected for the probe's temperature"}, name);
}

} // namespace straightedge::field
