#include "app/cli/field_summary.h"

#include "app/cli/summary_table.h"
#include "core/base/number_text.h"
#include "core/field/block_names.h"
#include "core/field/names.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace straightedge::cli {

namespace {

using namespace field;

using Rows = std::vector<std::vector<std::string>>;

std::string percent(double value) { return formatForPeople(value, 3) + " %"; }

/// Means wander about zero: no exponents for what is far below what anybody asks for.
std::string meanPercent(double value) {
  constexpr double shown = 1e-4;
  return std::abs(value) < shown ? "<0.0001 %" : percent(value);
}

std::string residualText(const BlockSummary& summary, double value) {
  return summary.block == Block::ProbeTemperature ? formatForPeople(value, 3) + " °C"
                                                  : formatForPeople(value * 1e6, 3) + " µT";
}

std::string blockTable(const FieldCalibration& calibration) {
  Rows rows{{"block", "axis", "rows", "left out", "coefficients", "residual sigma", "largest"}};
  for (const auto& [block, word] : blockWords) {
    bool on = false;
    for (const BlockSummary& summary : calibration.blocks) {
      if (summary.block == block) {
        rows.push_back({std::string(word), summary.axis ? std::string(axisName(*summary.axis)) : "all",
                        std::to_string(summary.rowsUsed), std::to_string(summary.rowsLeftOut),
                        std::to_string(summary.coefficients), residualText(summary, summary.residualSigma),
                        residualText(summary, summary.residualLargest)});
        on = true;
      }
    }
    if (!on) {
      rows.push_back({std::string(word), "all", "off"});
    }
  }
  return alignedColumns(rows);
}

std::string ordersTable(const FieldCalibration& calibration) {
  if (calibration.orders.empty()) {
    return {};
  }
  const int highest = std::ranges::max(calibration.orders, {}, &OrderError::order).order;
  Rows rows{{"largest error, order"}};
  for (int order = 1; order <= highest; ++order) {
    rows.front().push_back(std::to_string(order) + (order == calibration.order ? " *" : ""));
  }
  for (const Axis axis : allAxes) {
    std::vector<std::string> row{std::string(axisName(axis))};
    for (const OrderError& order : calibration.orders) {
      if (order.axis == axis) {
        row.push_back(percent(order.maxErrorPercent));
      }
    }
    if (row.size() > 1) {
      rows.push_back(std::move(row));
    }
  }
  return "\n" + alignedColumns(rows);
}

} // namespace

std::string verificationTable(const std::vector<VerificationRow>& rows, PercentOf of) {
  Rows table{{"axis", "state", "mean", "sigma", "peak", "points"}};
  for (const VerificationRow& row : rows) {
    const std::optional<ErrorFigures> figures = of == PercentOf::FullScale ? row.ofFullScale : row.ofReading;
    if (!figures) {
      continue;
    }
    table.push_back({std::string(axisName(row.axis)), std::string(stateName(row.state)), meanPercent(figures->mean),
                     percent(figures->sigma), percent(figures->peak), std::to_string(row.points)});
  }
  return alignedColumns(table);
}

std::string fieldSummaryOf(const FieldCalibration& calibration) {
  std::string text =
      calibration.source.file + ": " + std::to_string(calibration.source.points) + " rows, full scale " +
      formatForPeople(calibration.chain.fullScaleT, 3) + " T, reference temperature " +
      formatForPeople(calibration.chain.referenceTemperatureC, 3) + " °C, " +
      (calibration.method == FitMethod::Joint ? "all blocks fitted together\n" : "fitted block by block\n");
  text += blockTable(calibration) + ordersTable(calibration);
  for (const Axis axis : allAxes) {
    if (const std::string& explanation = calibration.orderExplanation[indexOf(axis)]; !explanation.empty()) {
      text += std::string(axisName(axis)) + ": " + explanation + "\n";
    }
  }
  if (calibration.probe) {
    const ProbeQuality& probe = *calibration.probe;
    text += "\nProbe temperature to " + formatForPeople(probe.standardUncertaintyC, 2) + " °C (1 sigma)";
    if (probe.hysteresisC) {
      text += ", loop between heating and cooling " + formatForPeople(*probe.hysteresisC, 2) + " °C wide";
    }
    text += "; " + probe.lagText + "\n";
  }
  if (!calibration.verification.empty()) {
    text +=
        "\nVerification, percent of full scale:\n" + verificationTable(calibration.verification, PercentOf::FullScale);
  }
  if (!calibration.stepwiseVerification.empty()) {
    std::vector<VerificationRow> final;
    std::ranges::copy_if(calibration.stepwiseVerification, std::back_inserter(final), [](const VerificationRow& row) {
      return row.state == VerifiedState::Calibrated || row.state == VerifiedState::AxisMatrix;
    });
    text += "\nThe same fitted step by step:\n" + verificationTable(final, PercentOf::FullScale);
  }
  return text;
}

} // namespace straightedge::cli
