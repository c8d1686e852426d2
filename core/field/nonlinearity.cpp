#include "core/field/nonlinearity.h"

#include "core/field/messages.h"
#include "core/field/names.h"
#include "core/field/plateau_checks.h"
#include "core/field/residuals.h"
#include "core/numerics/polynomial.h"
#include "core/numerics/statistics.h"

#include <algorithm>
#include <cmath>

namespace straightedge::field {

namespace {

OrderResult orderResult(int order, const numerics::PolynomialFit& fit, double fullScaleT) {
  OrderResult result;
  result.order = order;
  result.coefficients.assign(fit.coefficients.begin(), fit.coefficients.end());
  const double percent = 100.0 / fullScaleT;
  result.errorPercent = -percent * fit.residuals; // instrument − reference
  result.maxErrorPercent = numerics::largestMagnitude(result.errorPercent);
  result.rmsErrorPercent = numerics::rootMeanSquare(result.errorPercent);
  result.crossMaxPercent = percent * numerics::largestMagnitude(fit.leftOutResiduals);
  result.crossRmsPercent = percent * numerics::rootMeanSquare(fit.leftOutResiduals);
  result.covariance = fit.covariance;
  result.residualSigmaT = fit.residualSigma;
  return result;
}

const OrderResult* find(const std::vector<OrderResult>& orders, int order) {
  const auto found = std::ranges::find(orders, order, &OrderResult::order);
  return found == orders.end() ? nullptr : &*found;
}

std::string crossText(const OrderResult& result) {
  return percentText(result.crossRmsPercent) + " rms (" + percentText(result.crossMaxPercent) + " at most)";
}

/// Ratio as people say it: "9.8 times".
std::string times(double ratio) { return formatForPeople(ratio, 2) + " times"; }

std::string explain(const NonlinearityReport& report, const OrderResult& chosen) {
  std::string text = "Order " + std::to_string(chosen.order) + " leaves at most " +
                     percentText(chosen.maxErrorPercent) +
                     " of full scale at the plateaus it was fitted to and "
                     "foretells left-out plateaus to " +
                     crossText(chosen) + ".";
  if (const OrderResult* lower = find(report.orders, chosen.order - 1)) {
    const double ratio = lower->crossRmsPercent / chosen.crossRmsPercent;
    text += " Order " + std::to_string(lower->order) + " foretells them " +
            (ratio >= 1.0 ? times(ratio) + " worse" : times(1.0 / ratio) + " better") + ".";
  }
  const OrderResult* best = find(report.orders, report.bestCrossValidated);
  if (best == nullptr || best->order == chosen.order) {
    return text + " No other order foretells them better.";
  }
  const int more = best->order - chosen.order;
  text += " Order " + std::to_string(best->order) + " would foretell them " +
          times(chosen.crossRmsPercent / best->crossRmsPercent) + " better, to " + crossText(*best);
  if (more > 0) {
    text += ", for " + counted(static_cast<std::size_t>(more), "more coefficient") + " an axis";
  } else {
    text += ", with fewer coefficients: a higher order follows the noise";
  }
  return text + ".";
}

} // namespace

Result<NonlinearityReport> fitNonlinearity(const AxisPlateaus& plateaus, const NonlinearityOptions& options,
                                           const std::string& name) {
  if (auto sound = checkPlateaus(plateaus, options, name); !sound) {
    return std::unexpected(std::move(sound.error()));
  }
  const Eigen::VectorXd raw = plateaus.rawT(plateaus.axis);
  const Eigen::VectorXd reference = plateaus.referenceT();
  NonlinearityReport report;
  report.axis = plateaus.axis;
  report.order = options.order;
  report.beforePercent = 100.0 / options.fullScaleT * numerics::largestMagnitude(raw - reference);
  report.plateaus = plateaus;
  for (int order = lowestOrder; order <= highestOrder; ++order) {
    const auto fit = numerics::fitPolynomial(raw, reference, order, numerics::PolynomialDetail::WithoutInfluence);
    if (!fit || fit->freedom() < 1) {
      break;
    }
    report.orders.push_back(orderResult(order, *fit, options.fullScaleT));
    if (order == options.order) {
      report.block.covariance = fit->covariance;
      report.block.residuals = residualsOf(fit->residuals, fit->coefficients.size());
    }
  }
  const OrderResult* chosen = find(report.orders, options.order);
  if (chosen == nullptr) {
    return campaignFault(name, 0,
                         "axis " + std::string(axisName(plateaus.axis)) + ": the plateaus do not determine order " +
                             std::to_string(options.order),
                         "record plateaus at more fields, or choose a lower --order");
  }
  report.coefficients = chosen->coefficients;
  report.bestCrossValidated = std::ranges::min(report.orders, {}, &OrderResult::crossRmsPercent).order;
  report.explanation = explain(report, *chosen);
  report.block.rows = {plateaus.plateaus.size() * static_cast<std::size_t>(plateaus.rowsEach), plateaus.unlocked,
                       plateaus.unsettled, plateaus.surplus, plateaus.incomplete};
  report.block.how = "polynomial of order " + std::to_string(options.order) + " through the means of " +
                     counted(plateaus.plateaus.size(), "plateau") + " of " +
                     counted(static_cast<std::size_t>(plateaus.rowsEach), "row") + " each, " +
                     teslaText(reference.minCoeff()) + " to " + teslaText(reference.maxCoeff());
  return report;
}

} // namespace straightedge::field
