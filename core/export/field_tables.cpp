#include "core/export/field_tables.h"

#include "core/base/number_text.h"
#include "core/field/block_names.h"
#include "core/field/names.h"

#include <algorithm>
#include <array>
#include <span>

namespace straightedge::exporting {

namespace {

using namespace field;

/// One polynomial of an axis as files name it.
struct NamedPolynomial {
  Block block;
  std::string_view key;    ///< in calibration.json
  std::string_view column; ///< in a block's own table, before _0, _1, …
  std::string_view unit;   ///< of the value
  std::string_view over;   ///< unit of the argument
  std::span<const double> values;
};

template <typename Numbers>
std::span<const double> spanOf(const std::optional<Numbers>& numbers) {
  return numbers ? std::span<const double>(*numbers) : std::span<const double>();
}

std::array<NamedPolynomial, 6> polynomialsOf(const AxisChain& axis) {
  return {{{Block::Nonlinearity, "nonlinearity", "c", "T", "T", axis.nonlinearity},
           {Block::Offset, "offset_T", "offset", "T", "C", spanOf(axis.offsetT)},
           {Block::Sensitivity, "sensitivity_slope", "slope", "T/C", "T", spanOf(axis.sensitivitySlope)},
           {Block::Sensitivity, "sensitivity_intercept", "intercept", "T", "T", spanOf(axis.sensitivityIntercept)},
           {Block::Electronics, "electronics_T", "offset", "T", "C", spanOf(axis.electronicsT)},
           {Block::ElectronicsSensitivity, "electronics_sensitivity", "slope", "T/C", "T",
            spanOf(axis.electronicsSensitivity)}}};
}

std::string unitOf(const NamedPolynomial& polynomial, std::size_t power) {
  std::string unit(polynomial.unit);
  if (power > 0) {
    unit += "/" + std::string(polynomial.over) + (power > 1 ? "^" + std::to_string(power) : "");
  }
  return unit;
}

void addCoefficient(std::string& text, std::string_view block, std::string_view axis, std::string_view name,
                    std::size_t power, double value, const std::string& unit) {
  text += std::string(block) + "," + std::string(axis) + "," + std::string(name) + "," + std::to_string(power) + "," +
          formatDouble(value) + "," + unit + "\n";
}

/// A row per axis for the polynomials of one block; nothing where the block is off on every axis.
std::string blockTable(const CorrectionChain& chain, Block block) {
  std::vector<std::size_t> widths; // of each of the block's polynomials, the longest of the axes
  std::string header = "axis";
  for (std::size_t i = 0; i < 6; ++i) {
    std::size_t width = 0;
    std::string_view column;
    for (const AxisChain& axis : chain.axes) {
      const NamedPolynomial polynomial = polynomialsOf(axis)[i];
      if (polynomial.block == block) {
        width = std::max(width, polynomial.values.size());
        column = polynomial.column;
      }
    }
    widths.push_back(width);
    for (std::size_t power = 0; power < width; ++power) {
      header += "," + std::string(column) + "_" + std::to_string(power);
    }
  }
  if (std::ranges::max(widths) == 0) {
    return {};
  }
  std::string text = header + "\n";
  for (const Axis axis : allAxes) {
    text += axisName(axis);
    const auto polynomials = polynomialsOf(chain.axes[indexOf(axis)]);
    for (std::size_t i = 0; i < polynomials.size(); ++i) {
      for (std::size_t power = 0; power < widths[i]; ++power) {
        text += ",";
        text += power < polynomials[i].values.size() ? formatDouble(polynomials[i].values[power]) : std::string();
      }
    }
    text += '\n';
  }
  return text;
}

std::string matrixTable(const Eigen::Matrix3d& matrix) {
  std::string text = "axis,x,y,z\n";
  for (const Axis axis : allAxes) {
    const auto row = static_cast<Eigen::Index>(indexOf(axis));
    text += std::string(axisName(axis)) + "," + formatDouble(matrix(row, 0)) + "," + formatDouble(matrix(row, 1)) +
            "," + formatDouble(matrix(row, 2)) + "\n";
  }
  return text;
}

std::string orEmpty(const std::optional<double>& value) { return value ? formatDouble(*value) : std::string(); }

} // namespace

std::string fieldCoefficientsCsv(const FieldCalibration& calibration) {
  const CorrectionChain& chain = calibration.chain;
  std::string text = "block,axis,name,power,value,unit\n";
  if (chain.pt100) {
    addCoefficient(text, blockName(Block::ProbeTemperature), "", "intercept_C", 0, chain.pt100->interceptC, "C");
    addCoefficient(text, blockName(Block::ProbeTemperature), "", "slope_C_per_ohm", 1, chain.pt100->slopeCPerOhm,
                   "C/ohm");
  }
  for (const Axis axis : allAxes) {
    for (const NamedPolynomial& polynomial : polynomialsOf(chain.axes[indexOf(axis)])) {
      for (std::size_t power = 0; power < polynomial.values.size(); ++power) {
        addCoefficient(text, blockName(polynomial.block), axisName(axis), polynomial.key, power,
                       polynomial.values[power], unitOf(polynomial, power));
      }
    }
  }
  if (chain.axisMatrix) {
    for (const Axis axis : allAxes) {
      for (std::size_t column = 0; column < 3; ++column) {
        const double value =
            (*chain.axisMatrix)(static_cast<Eigen::Index>(indexOf(axis)), static_cast<Eigen::Index>(column));
        addCoefficient(text, blockName(Block::AxisMatrix), axisName(axis), "axis_matrix", column, value, "T/T");
      }
    }
  }
  return text;
}

std::vector<NamedTable> fieldBlockTables(const FieldCalibration& calibration) {
  const CorrectionChain& chain = calibration.chain;
  std::vector<NamedTable> tables;
  if (chain.pt100) {
    tables.push_back({"pt100.csv", "slope_C_per_ohm,intercept_C\n" + formatDouble(chain.pt100->slopeCPerOhm) + "," +
                                       formatDouble(chain.pt100->interceptC) + "\n"});
  }
  for (const Block block :
       {Block::Nonlinearity, Block::Offset, Block::Sensitivity, Block::Electronics, Block::ElectronicsSensitivity}) {
    if (std::string text = blockTable(chain, block); !text.empty()) {
      tables.push_back({std::string(blockName(block)) + ".csv", std::move(text)});
    }
  }
  if (chain.axisMatrix) {
    tables.push_back({"axis-matrix.csv", matrixTable(*chain.axisMatrix)});
  }
  if (!calibration.orders.empty()) {
    tables.push_back({"nonlinearity-orders.csv", ordersCsv(calibration)});
  }
  if (!calibration.verification.empty()) {
    tables.push_back({"verification.csv", fieldVerificationCsv(calibration)});
  }
  return tables;
}

std::string ordersCsv(const FieldCalibration& calibration) {
  std::string text = "axis,order,max_error_percent,cross_validated_max_percent,cross_validated_rms_percent\n";
  for (const OrderError& order : calibration.orders) {
    text += std::string(axisName(order.axis)) + "," + std::to_string(order.order) + "," +
            formatDouble(order.maxErrorPercent) + "," + orEmpty(order.crossMaxPercent) + "," +
            orEmpty(order.crossRmsPercent) + "\n";
  }
  return text;
}

std::string fieldVerificationCsv(const FieldCalibration& calibration) {
  std::string text = "axis,state,mean_percent,sigma_percent,peak_percent,mean_percent_of_reading,"
                     "sigma_percent_of_reading,peak_percent_of_reading,points\n";
  const auto three = [](const ErrorFigures& figures) {
    return formatDouble(figures.mean) + "," + formatDouble(figures.sigma) + "," + formatDouble(figures.peak);
  };
  for (const VerificationRow& row : calibration.verification) {
    text += std::string(axisName(row.axis)) + "," + std::string(stateName(row.state)) + "," + three(row.ofFullScale) +
            "," + (row.ofReading ? three(*row.ofReading) : std::string(",,")) + "," + std::to_string(row.points) + "\n";
  }
  return text;
}

} // namespace straightedge::exporting
