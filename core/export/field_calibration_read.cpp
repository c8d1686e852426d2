#include "core/base/file_bytes.h"
#include "core/export/calibration_head.h"
#include "core/export/field_calibration_json.h"
#include "core/export/field_uncertainty_json.h"
#include "core/export/json_optional.h"
#include "core/field/block_names.h"
#include "core/field/names.h"

#include <Eigen/LU>

#include <algorithm>

namespace straightedge::exporting {

namespace {

using namespace field;

constexpr std::size_t mostCoefficients = 16;

std::vector<double> readNumbers(JsonReader& reader, const JsonNode& parent, std::string_view key) {
  const JsonNode list = reader.list(parent, key);
  std::vector<double> numbers;
  numbers.reserve(list.size());
  for (std::size_t i = 0; i < list.size(); ++i) {
    numbers.push_back(reader.asNumber(list.item(i)));
  }
  return numbers;
}

/// One to mostCoefficients of them; nothing where the block is off.
std::optional<std::vector<double>> readPolynomial(JsonReader& reader, const JsonNode& parent, std::string_view key) {
  const JsonNode node = parent.optional(key);
  if (!node) {
    return std::nullopt;
  }
  std::vector<double> numbers = readNumbers(reader, parent, key);
  if (!reader.problem() && (numbers.empty() || numbers.size() > mostCoefficients)) {
    reader.blame(node.path + " has " + std::to_string(numbers.size()) + " entries instead of 1 to " +
                 std::to_string(mostCoefficients));
  }
  return numbers;
}

std::optional<std::array<double, 2>> readLine(JsonReader& reader, const JsonNode& parent, std::string_view key) {
  const JsonNode node = parent.optional(key);
  if (!node) {
    return std::nullopt;
  }
  const std::vector<double> numbers = readNumbers(reader, parent, key);
  if (reader.problem()) {
    return std::nullopt;
  }
  if (numbers.size() != 2) {
    reader.blame(node.path + " has " + std::to_string(numbers.size()) + " entries instead of 2");
    return std::nullopt;
  }
  return std::array<double, 2>{numbers[0], numbers[1]};
}

AxisChain readAxis(JsonReader& reader, const JsonNode& node) {
  AxisChain axis;
  axis.nonlinearity = readPolynomial(reader, node, "nonlinearity").value_or(std::vector<double>{});
  axis.offsetT = readLine(reader, node, "offset_T");
  axis.sensitivitySlope = readPolynomial(reader, node, "sensitivity_slope");
  axis.sensitivityIntercept = readPolynomial(reader, node, "sensitivity_intercept");
  axis.electronicsT = readLine(reader, node, "electronics_T");
  axis.electronicsSensitivity = readLine(reader, node, "electronics_sensitivity");
  return axis;
}

std::optional<Eigen::Matrix3d> readMatrix(JsonReader& reader, const JsonNode& root) {
  const JsonNode list = listIfAny(reader, root, "axis_matrix");
  if (!list) {
    return std::nullopt;
  }
  Eigen::Matrix3d matrix;
  for (std::size_t row = 0; row < 3; ++row) {
    const JsonNode line = row < list.size() ? list.item(row) : JsonNode{};
    if (list.size() != 3 || !line.value->is_array() || line.size() != 3) {
      reader.blame("axis_matrix is not 3 rows of 3 numbers");
      return std::nullopt;
    }
    for (std::size_t column = 0; column < 3; ++column) {
      matrix(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) = reader.asNumber(line.item(column));
    }
  }
  if (!reader.problem() && !Eigen::FullPivLU<Eigen::Matrix3d>(matrix).isInvertible()) {
    reader.blame("axis_matrix is singular");
  }
  return matrix;
}

CorrectionChain readChain(JsonReader& reader, const JsonNode& root) {
  CorrectionChain chain;
  chain.fullScaleT = reader.number(root, "full_scale_T");
  if (!reader.problem() && chain.fullScaleT <= 0.0) {
    reader.blame("full_scale_T is not positive");
  }
  chain.referenceTemperatureC = reader.number(root, "reference_temperature_C");
  if (const JsonNode pt100 = objectIfAny(reader, root, "pt100")) {
    chain.pt100 = Pt100Line{reader.number(pt100, "slope_C_per_ohm"), reader.number(pt100, "intercept_C")};
  }
  const JsonNode axes = reader.object(root, "axes");
  for (const Axis axis : allAxes) {
    const JsonNode node = axes ? reader.object(axes, axisName(axis)) : axes;
    if (!node || reader.problem()) {
      return chain;
    }
    AxisChain& blocks = chain.axes[indexOf(axis)];
    blocks = readAxis(reader, node);
    if (!reader.problem() && !chain.pt100 && (blocks.offsetT || blocks.sensitivitySlope)) {
      reader.blame("pt100 is missing, which " + node.path + "." + (blocks.offsetT ? "offset_T" : "sensitivity_slope") +
                   " needs");
    }
  }
  chain.axisMatrix = readMatrix(reader, root);
  return chain;
}

ErrorFigures readFigures(JsonReader& reader, const JsonNode& node) {
  return {reader.number(node, "mean_percent"), reader.number(node, "sigma_percent"),
          reader.number(node, "peak_percent")};
}

void readVerification(JsonReader& reader, const JsonNode& list, std::vector<VerificationRow>& rows) {
  for (std::size_t i = 0; i < list.size() && !reader.problem(); ++i) {
    const JsonNode node = list.item(i);
    if (!reader.requireObject(node)) {
      return;
    }
    VerificationRow row;
    row.axis = readWord(reader, node, "axis", axisWords);
    row.state = readWord(reader, node, "state", stateWords);
    row.ofFullScale = readFigures(reader, node);
    if (const JsonNode ofReading = objectIfAny(reader, node, "of_reading")) {
      row.ofReading = readFigures(reader, ofReading);
    }
    row.points =
        node.optional("points") ? static_cast<std::size_t>(reader.integer(node, "points", 0, largestCount)) : 0;
    rows.push_back(row);
  }
}

void readOrders(JsonReader& reader, const JsonNode& root, std::vector<OrderError>& orders) {
  const JsonNode list = listIfAny(reader, root, "nonlinearity_orders");
  for (std::size_t i = 0; i < list.size() && !reader.problem(); ++i) {
    const JsonNode node = list.item(i);
    if (!reader.requireObject(node)) {
      return;
    }
    orders.push_back({readWord(reader, node, "axis", axisWords),
                      static_cast<int>(reader.integer(node, "order", 0, mostCoefficients)),
                      reader.number(node, "max_error_percent"),
                      optionalNumber(reader, node, "cross_validated_max_percent"),
                      optionalNumber(reader, node, "cross_validated_rms_percent")});
  }
}

BlockSummary readBlock(JsonReader& reader, const JsonNode& node) {
  BlockSummary summary;
  summary.block = readWord(reader, node, "block", blockWords);
  if (node.optional("axis")) {
    summary.axis = readWord(reader, node, "axis", axisWords);
  }
  const auto count = [&](std::string_view key) {
    return node.optional(key) ? static_cast<std::size_t>(reader.integer(node, key, 0, largestCount)) : std::size_t{0};
  };
  summary.how = textIfAny(reader, node, "how");
  summary.rowsUsed = count("rows_used");
  summary.rowsLeftOut = count("rows_left_out");
  summary.coefficients = count("coefficients");
  summary.residualSigma = numberIfAny(reader, node, "residual_sigma");
  summary.residualLargest = numberIfAny(reader, node, "residual_largest");
  return summary;
}

void readHowMade(JsonReader& reader, const JsonNode& root, FieldCalibration& calibration) {
  if (root.optional("method")) {
    calibration.method = readWord(reader, root, "method", methodWords);
  }
  calibration.jointHow = textIfAny(reader, root, "joint_fit");
  readVerification(reader, listIfAny(reader, root, "verification_stepwise"), calibration.stepwiseVerification);
  if (root.optional("nonlinearity_order")) {
    calibration.order = static_cast<int>(reader.integer(root, "nonlinearity_order", 1, mostCoefficients));
  }
  if (const JsonNode explanation = objectIfAny(reader, root, "order_explanation")) {
    for (const Axis axis : allAxes) {
      calibration.orderExplanation[indexOf(axis)] = textIfAny(reader, explanation, axisName(axis));
    }
  }
  if (const JsonNode probe = objectIfAny(reader, root, "probe")) {
    calibration.probe = ProbeQuality{numberIfAny(reader, probe, "standard_uncertainty_C"),
                                     optionalNumber(reader, probe, "hysteresis_C"),
                                     optionalNumber(reader, probe, "lag_s"), textIfAny(reader, probe, "lag")};
  }
  const JsonNode blocks = listIfAny(reader, root, "blocks");
  for (std::size_t i = 0; i < blocks.size() && !reader.problem(); ++i) {
    if (const JsonNode node = blocks.item(i); reader.requireObject(node)) {
      calibration.blocks.push_back(readBlock(reader, node));
    }
  }
  const JsonNode warnings = listIfAny(reader, root, "warnings");
  for (std::size_t i = 0; i < warnings.size() && !reader.problem(); ++i) {
    if (const JsonNode node = warnings.item(i); reader.requireObject(node)) {
      calibration.warnings.push_back({readWord(reader, node, "block", blockWords), reader.text(node, "text")});
    }
  }
}

} // namespace

bool isFieldCalibration(std::string_view text) {
  const auto parsed = parseJson(text, {});
  if (!parsed || !parsed->is_object()) {
    return false;
  }
  const auto kind = parsed->find("kind");
  return kind != parsed->end() && *kind == "field";
}

Result<FieldCalibration> fieldCalibrationFromJson(std::string_view text, const std::string& name) {
  const auto parsed = parseJson(text, name, fieldFitAgain);
  if (!parsed) {
    return std::unexpected(parsed.error());
  }
  JsonReader reader(name, fieldFitAgain);
  const JsonNode root{.value = &*parsed, .path = {}};
  CalibrationHead head = readCalibrationHead(reader, root, "field");
  FieldCalibration calibration;
  if (!reader.problem()) {
    calibration.created = std::move(head.created);
    calibration.software = std::move(head.software);
    calibration.source = std::move(head.source);
    calibration.traceability = std::move(head.traceability);
    calibration.chain = readChain(reader, root);
  }
  if (!reader.problem()) {
    readOrders(reader, root, calibration.orders);
    readVerification(reader, listIfAny(reader, root, "verification"), calibration.verification);
    readVerification(reader, listIfAny(reader, root, "verification_stages"), calibration.verification);
    // In the file the published states come first; here they stand in the chain's order.
    std::ranges::stable_sort(calibration.verification, {},
                             [](const VerificationRow& row) { return std::pair(row.axis, row.state); });
    calibration.uncertainty = readFieldUncertainty(reader, root);
    readHowMade(reader, root, calibration);
  }
  if (const auto& problem = reader.problem()) {
    return std::unexpected(*problem);
  }
  return calibration;
}

Result<FieldCalibration> readFieldCalibration(const std::string& path) {
  const auto bytes = readFileBytes(path);
  if (!bytes) {
    return std::unexpected(bytes.error());
  }
  return fieldCalibrationFromJson(*bytes, inputName(path));
}

} // namespace straightedge::exporting
