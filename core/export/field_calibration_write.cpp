#include "core/base/json_writer.h"
#include "core/export/calibration_head.h"
#include "core/export/field_calibration_json.h"
#include "core/export/field_uncertainty_json.h"
#include "core/field/block_names.h"
#include "core/field/names.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace straightedge::exporting {

namespace {

using namespace field;

void writeNumbers(JsonWriter& json, std::string_view name, std::span<const double> numbers) {
  json.openList(name, true);
  for (const double number : numbers) {
    json.value(number);
  }
  json.endList();
}

template <typename Numbers>
void writeBlock(JsonWriter& json, std::string_view name, const std::optional<Numbers>& numbers) {
  if (numbers) {
    writeNumbers(json, name, *numbers);
  } else {
    json.key(name);
    json.null();
  }
}

void writeAxis(JsonWriter& json, Axis axis, const AxisChain& blocks) {
  json.openObject(axisName(axis));
  writeBlock(json, "nonlinearity",
             blocks.nonlinearity.empty() ? std::nullopt : std::optional(std::span(blocks.nonlinearity)));
  writeBlock(json, "offset_T", blocks.offsetT);
  writeBlock(json, "sensitivity_slope", blocks.sensitivitySlope);
  writeBlock(json, "sensitivity_intercept", blocks.sensitivityIntercept);
  writeBlock(json, "electronics_T", blocks.electronicsT);
  writeBlock(json, "electronics_sensitivity", blocks.electronicsSensitivity);
  json.endObject();
}

double angleDeg(const Eigen::RowVector3d& a, const Eigen::RowVector3d& b) {
  const double cosine = a.dot(b) / (a.norm() * b.norm());
  return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / std::numbers::pi;
}

void writeMatrix(JsonWriter& json, const std::optional<Eigen::Matrix3d>& matrix) {
  json.key("axis_matrix");
  if (!matrix) {
    json.null();
    return;
  }
  json.beginList();
  for (Eigen::Index row = 0; row < 3; ++row) {
    json.beginList(true);
    for (Eigen::Index column = 0; column < 3; ++column) {
      json.value((*matrix)(row, column));
    }
    json.endList();
  }
  json.endList();
  json.openObject("axis_angles_deg", true);
  json.member("xy", angleDeg(matrix->row(0), matrix->row(1)));
  json.member("xz", angleDeg(matrix->row(0), matrix->row(2)));
  json.member("yz", angleDeg(matrix->row(1), matrix->row(2)));
  json.endObject();
}

void writeChain(JsonWriter& json, const CorrectionChain& chain) {
  json.member("full_scale_T", chain.fullScaleT);
  json.member("reference_temperature_C", chain.referenceTemperatureC);
  json.key("pt100");
  if (chain.pt100) {
    json.beginObject(true);
    json.member("slope_C_per_ohm", chain.pt100->slopeCPerOhm);
    json.member("intercept_C", chain.pt100->interceptC);
    json.endObject();
  } else {
    json.null();
  }
  json.openObject("axes");
  for (const Axis axis : allAxes) {
    writeAxis(json, axis, chain.axes[indexOf(axis)]);
  }
  json.endObject();
  writeMatrix(json, chain.axisMatrix);
}

void writeOrders(JsonWriter& json, const std::vector<OrderError>& orders) {
  json.openList("nonlinearity_orders");
  for (const OrderError& order : orders) {
    json.beginObject(true);
    json.member("axis", axisName(order.axis));
    json.member("order", order.order);
    json.member("max_error_percent", order.maxErrorPercent);
    if (order.crossMaxPercent) {
      json.member("cross_validated_max_percent", *order.crossMaxPercent);
    }
    if (order.crossRmsPercent) {
      json.member("cross_validated_rms_percent", *order.crossRmsPercent);
    }
    json.endObject();
  }
  json.endList();
}

bool isPublished(VerifiedState state) {
  return state == VerifiedState::Uncalibrated || state == VerifiedState::Calibrated;
}

/// `published`: only the states that have a place under "verification", or only the others; all without.
void writeVerification(JsonWriter& json, std::string_view name, const std::vector<VerificationRow>& rows,
                       std::optional<bool> published) {
  json.openList(name);
  for (const VerificationRow& row : rows) {
    if (published && isPublished(row.state) != *published) {
      continue;
    }
    json.beginObject(true);
    json.member("axis", axisName(row.axis));
    json.member("state", stateName(row.state));
    json.member("mean_percent", row.ofFullScale.mean);
    json.member("sigma_percent", row.ofFullScale.sigma);
    json.member("peak_percent", row.ofFullScale.peak);
    if (row.ofReading) {
      json.openObject("of_reading", true);
      json.member("mean_percent", row.ofReading->mean);
      json.member("sigma_percent", row.ofReading->sigma);
      json.member("peak_percent", row.ofReading->peak);
      json.endObject();
    }
    json.member("points", row.points);
    json.endObject();
  }
  json.endList();
}

void writeBlocks(JsonWriter& json, const std::vector<BlockSummary>& blocks) {
  json.openList("blocks");
  for (const BlockSummary& summary : blocks) {
    json.beginObject();
    json.member("block", blockName(summary.block));
    if (summary.axis) {
      json.member("axis", axisName(*summary.axis));
    }
    json.member("how", summary.how);
    json.member("rows_used", summary.rowsUsed);
    json.member("rows_left_out", summary.rowsLeftOut);
    json.member("coefficients", summary.coefficients);
    json.member("residual_sigma", summary.residualSigma);
    json.member("residual_largest", summary.residualLargest);
    json.endObject();
  }
  json.endList();
}

void writeHowMade(JsonWriter& json, const FieldCalibration& calibration) {
  json.member("method", methodWords[static_cast<std::size_t>(calibration.method)].second);
  if (calibration.method == field::FitMethod::Joint) {
    json.member("joint_fit", calibration.jointHow);
    writeVerification(json, "verification_stepwise", calibration.stepwiseVerification, std::nullopt);
  }
  json.member("nonlinearity_order", calibration.order);
  json.openObject("order_explanation");
  for (const Axis axis : allAxes) {
    json.member(axisName(axis), calibration.orderExplanation[indexOf(axis)]);
  }
  json.endObject();
  if (calibration.probe) {
    json.openObject("probe");
    json.member("standard_uncertainty_C", calibration.probe->standardUncertaintyC);
    if (calibration.probe->hysteresisC) {
      json.member("hysteresis_C", *calibration.probe->hysteresisC);
    }
    if (calibration.probe->lagS) {
      json.member("lag_s", *calibration.probe->lagS);
    }
    json.member("lag", calibration.probe->lagText);
    json.endObject();
  }
  writeBlocks(json, calibration.blocks);
  if (!calibration.warnings.empty()) {
    json.openList("warnings");
    for (const FieldWarning& warning : calibration.warnings) {
      json.beginObject(true);
      json.member("block", blockName(warning.block));
      json.member("text", warning.text);
      json.endObject();
    }
    json.endList();
  }
}

} // namespace

std::string fieldCalibrationToJson(const FieldCalibration& calibration) {
  JsonWriter json;
  json.beginObject();
  writeCalibrationHead(json, "field",
                       {calibration.created, calibration.software, calibration.source, calibration.traceability});
  writeChain(json, calibration.chain);
  writeOrders(json, calibration.orders);
  writeVerification(json, "verification", calibration.verification, true);
  writeVerification(json, "verification_stages", calibration.verification, false);
  writeFieldUncertainty(json, calibration.uncertainty);
  writeHowMade(json, calibration);
  json.endObject();
  return json.take();
}

} // namespace straightedge::exporting
