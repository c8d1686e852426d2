#include "core/field/field_sweeps.h"

#include "core/field/messages.h"
#include "core/field/names.h"
#include "core/field/span_checks.h"
#include "core/numerics/polynomial.h"

#include <algorithm>
#include <cmath>

namespace straightedge::field {

namespace {

std::optional<FieldSweep> sweepOf(const SweepInputs& inputs, Eigen::Index first, Eigen::Index count) {
  if (count < leastRows) {
    return std::nullopt;
  }
  const Eigen::VectorXd temperature = inputs.temperatureC.segment(first, count);
  const auto value = inputs.valueT.segment(first, count);
  const auto reference = inputs.rows.referenceT.segment(first, count);
  FieldSweep sweep;
  sweep.spanC = temperature.maxCoeff() - temperature.minCoeff();
  if (sweep.spanC < leastSpanC) {
    return std::nullopt;
  }
  const Eigen::VectorXd error = value - reference;
  const auto fit = numerics::fitPolynomial(temperature, error, 1, numerics::PolynomialDetail::WithoutInfluence);
  if (!fit) {
    return std::nullopt;
  }
  sweep.referenceT = reference.mean();
  sweep.valueT = value.mean();
  sweep.intercept = fit->coefficients[0];
  sweep.slope = fit->coefficients[1];
  sweep.interceptSigma = fit->sigma(0);
  sweep.slopeSigma = fit->sigma(1);
  sweep.covariance = fit->covariance(0, 1);
  sweep.noiseT = fit->residualSigma;
  sweep.meanErrorT = error.mean();
  sweep.first = first;
  sweep.rows = count;
  sweep.line = inputs.rows.line[static_cast<std::size_t>(first)];
  return sweep;
}

std::unexpected<Error> tooFewFields(const SweepInputs& inputs, const std::vector<FieldSweep>& sweeps,
                                    Eigen::Index moved, const std::string& name) {
  const std::string step =
      std::string(stepName(inputs.rows.step)) + " of axis " + std::string(axisName(*inputs.rows.axis));
  if (sweeps.empty() && moved == 0) {
    if (auto moves = checkSpan(inputs.temperatureC, inputs.thing, step, name); !moves) {
      return std::unexpected(std::move(moves.error()));
    }
  }
  return campaignFault(name, 0,
                       "the step " + step + " sweeps the temperature of the " + inputs.thing + " at " +
                           counted(static_cast<std::size_t>(distinctFields(sweeps)), "locked field") +
                           ", 2 or more are needed (of " + std::to_string(inputs.rows.runBegin.size()) +
                           " recorded, each with at least " + std::to_string(leastRows) + " rows over " +
                           celsiusText(leastSpanC) + ")",
                       "record the step again at several fields of both signs");
}

} // namespace

Result<std::vector<FieldSweep>> sweepsOf(const SweepInputs& inputs, const std::string& name) {
  const StepRows& rows = inputs.rows;
  if (auto enough = checkRowCount(rows, name); !enough) {
    return std::unexpected(std::move(enough.error()));
  }
  std::vector<FieldSweep> sweeps;
  Eigen::Index moved = 0;
  for (std::size_t run = 0; run < rows.runBegin.size(); ++run) {
    const Eigen::Index first = rows.runBegin[run];
    const Eigen::Index count = rows.runEnd(run) - first;
    const auto temperature = inputs.temperatureC.segment(first, count);
    moved += temperature.maxCoeff() - temperature.minCoeff() >= leastSpanC ? 1 : 0;
    if (auto sweep = sweepOf(inputs, first, count)) {
      sweeps.push_back(*sweep);
    }
  }
  if (distinctFields(sweeps) < 2) {
    return tooFewFields(inputs, sweeps, moved, name);
  }
  const auto [least, most] = std::ranges::minmax(sweeps, {}, &FieldSweep::referenceT);
  if (least.referenceT >= 0.0 || most.referenceT <= 0.0) {
    return campaignFault(name, 0,
                         "the step " + std::string(stepName(rows.step)) + " of axis " +
                             std::string(axisName(*rows.axis)) + " has fields of one sign only, from " +
                             teslaText(least.referenceT) + " to " + teslaText(most.referenceT),
                         "record it at fields of both signs");
  }
  return sweeps;
}

int distinctFields(const std::vector<FieldSweep>& sweeps) {
  std::vector<double> fields;
  fields.reserve(sweeps.size());
  for (const FieldSweep& sweep : sweeps) {
    fields.push_back(sweep.referenceT);
  }
  std::ranges::sort(fields);
  int count = fields.empty() ? 0 : 1;
  for (std::size_t i = 1; i < fields.size(); ++i) {
    count += fields[i] - fields[i - 1] > plateauToleranceT ? 1 : 0;
  }
  return count;
}

Eigen::VectorXd errorsAfter(const SweepInputs& inputs, const Eigen::VectorXd& afterT, std::vector<FieldSweep>& sweeps) {
  Eigen::Index total = 0;
  for (const FieldSweep& sweep : sweeps) {
    total += sweep.rows;
  }
  Eigen::VectorXd all(total);
  Eigen::Index at = 0;
  for (FieldSweep& sweep : sweeps) {
    auto errors = all.segment(at, sweep.rows);
    errors = afterT.segment(sweep.first, sweep.rows) - inputs.rows.referenceT.segment(sweep.first, sweep.rows);
    sweep.meanErrorAfterT = errors.mean();
    at += sweep.rows;
  }
  return all;
}

Eigen::VectorXd valuesOf(const std::vector<FieldSweep>& sweeps, double FieldSweep::* member) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(sweeps.size()));
  std::ranges::transform(sweeps, values.begin(), [member](const FieldSweep& sweep) { return sweep.*member; });
  return values;
}

} // namespace straightedge::field
