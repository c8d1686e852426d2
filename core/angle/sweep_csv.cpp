#include "core/angle/sweep_csv.h"

#include "core/angle/sweep_columns.h"
#include "core/base/file_bytes.h"
#include "core/base/number_text.h"
#include "core/base/sha256.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace straightedge::angle {

namespace {

constexpr std::size_t previewRows = 50;

std::optional<std::size_t> columnOf(const SweepMapping& mapping, SweepColumn role) {
  const auto found = std::find(mapping.begin(), mapping.end(), role);
  return found == mapping.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - mapping.begin()));
}

std::unexpected<Error> badCell(const CsvTable& table, std::size_t row, std::size_t column, const char* wanted) {
  return fail(ErrorKind::Input,
              table.columnName(column) + " holds \"" + std::string(table.cell(row, column).substr(0, 40)) + "\"",
              wanted, table.where(row));
}

Result<void> readNumbers(const CsvTable& table, std::size_t column, std::vector<double>& into) {
  into.reserve(table.rows());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    auto value = table.number(row, column);
    if (!value) {
      return std::unexpected(std::move(value.error()));
    }
    into.push_back(*value);
  }
  return {};
}

/// An optional quantity: a cell may be empty, which reads as NaN.
Result<void> readNumbersOrGaps(const CsvTable& table, std::size_t column, std::vector<double>& into) {
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto value = table.numberIfAny(row, column);
    if (!value && !table.cell(row, column).empty()) {
      return badCell(table, row, column, "write a number or leave the cell empty");
    }
    into.push_back(value.value_or(std::numeric_limits<double>::quiet_NaN()));
  }
  return {};
}

Result<void> readTurns(const CsvTable& table, std::size_t column, std::vector<int>& into) {
  constexpr double mostTurns = 1e6;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto value = table.numberIfAny(row, column);
    if (!value || !(std::abs(*value) <= mostTurns) || std::floor(*value) != *value) {
      return badCell(table, row, column, "number the turns 0, 1, … or remove the column");
    }
    into.push_back(static_cast<int>(*value));
  }
  return {};
}

Result<void> readDirections(const CsvTable& table, std::size_t column, std::vector<int>& into) {
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto value = parseDirection(table.cell(row, column), table.layout().decimalPoint);
    if (!value) {
      return badCell(table, row, column, "write 1 for a rising encoder and -1 for a falling one, or remove the column");
    }
    into.push_back(*value);
  }
  return {};
}

Result<Sweep> sweepFrom(const CsvTable& table, const SweepMapping& mapping) {
  if (auto fits = checkMapping(table, mapping); !fits) {
    return std::unexpected(std::move(fits.error()));
  }
  Sweep sweep;
  Result<void> done;
  const auto take = [&](SweepColumn role, auto&& reader, auto& into) {
    if (const auto column = columnOf(mapping, role); column && done) {
      done = reader(table, *column, into);
    }
  };
  take(SweepColumn::Encoder, readNumbers, sweep.encoderDeg);
  take(SweepColumn::Sensor, readNumbers, sweep.sensorDeg);
  take(SweepColumn::Turn, readTurns, sweep.turn);
  take(SweepColumn::Direction, readDirections, sweep.direction);
  take(SweepColumn::Temperature, readNumbersOrGaps, sweep.temperatureC);
  take(SweepColumn::Time, readNumbersOrGaps, sweep.timeS);
  if (!done) {
    return std::unexpected(std::move(done.error()));
  }
  sweep.line.reserve(table.rows());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    sweep.line.push_back(table.line(row));
  }
  return sweep;
}

} // namespace

const char* sweepColumnTitle(SweepColumn column) {
  switch (column) {
  case SweepColumn::Ignored:
    return "";
  case SweepColumn::Encoder:
    return "encoder_deg";
  case SweepColumn::Sensor:
    return "sensor_deg";
  case SweepColumn::Turn:
    return "turn";
  case SweepColumn::Direction:
    return "direction";
  case SweepColumn::Temperature:
    return "temperature_C";
  case SweepColumn::Time:
    return "time_s";
  }
  return "";
}

SweepMapping CsvPreview::mapping() const {
  SweepMapping roles;
  for (const Column& column : columns) {
    roles.push_back(column.role);
  }
  return roles;
}

Result<CsvPreview> inspectCsv(const std::string& path) {
  const auto table = CsvTable::read(path);
  if (!table) {
    return std::unexpected(table.error());
  }
  CsvPreview preview;
  preview.layout = table->layout();
  preview.rowCount = table->rows();
  const SweepMapping mapping = guessMapping(*table);
  for (std::size_t column = 0; column < table->columns(); ++column) {
    CsvPreview::Column entry;
    const auto title = table->title(column);
    entry.title = title.empty() ? "column " + std::to_string(column + 1) : std::string(title);
    entry.role = mapping[column];
    for (std::size_t row = 0; row < table->rows(); ++row) {
      if (const auto value = table->numberIfAny(row, column); value && std::isfinite(*value)) {
        entry.minimum = std::min(entry.minimum.value_or(*value), *value);
        entry.maximum = std::max(entry.maximum.value_or(*value), *value);
      }
    }
    preview.columns.push_back(std::move(entry));
  }
  for (std::size_t row = 0; row < std::min(previewRows, table->rows()); ++row) {
    auto& cells = preview.firstRows.emplace_back();
    for (std::size_t column = 0; column < table->columns(); ++column) {
      cells.emplace_back(table->cell(row, column));
    }
  }
  if (auto sweep = sweepFrom(*table, mapping); !sweep) {
    preview.problem = std::move(sweep.error());
  }
  return preview;
}

Result<Sweep> readSweepCsv(const std::string& path, const std::optional<SweepMapping>& mapping) {
  auto bytes = readFileBytes(path);
  if (!bytes) {
    return std::unexpected(std::move(bytes.error()));
  }
  return parseSweepCsv(std::move(*bytes), inputName(path), inputFileName(path), mapping);
}

Result<Sweep> parseSweepCsv(std::string bytes, const std::string& name, const std::string& fileName,
                            const std::optional<SweepMapping>& mapping) {
  std::string digest = sha256Hex(bytes);
  const auto table = CsvTable::parse(std::move(bytes), name);
  if (!table) {
    return std::unexpected(table.error());
  }
  auto sweep = sweepFrom(*table, mapping ? *mapping : guessMapping(*table));
  if (sweep) {
    sweep->source = {fileName, std::move(digest), static_cast<long long>(sweep->size())};
  }
  return sweep;
}

std::string sweepToCsv(const Sweep& sweep) {
  std::string text = "encoder_deg,sensor_deg";
  text += sweep.turn.empty() ? "" : ",turn";
  text += sweep.direction.empty() ? "" : ",direction";
  text += sweep.temperatureC.empty() ? "" : ",temperature_C";
  text += sweep.timeS.empty() ? "" : ",time_s";
  text += '\n';
  const auto addGapOrNumber = [&text](double value) { text += std::isnan(value) ? "," : "," + formatDouble(value); };
  for (std::size_t row = 0; row < sweep.size(); ++row) {
    if (!sweep.isEnabled(row)) {
      continue;
    }
    text += formatDouble(sweep.encoderDeg[row]) + "," + formatDouble(sweep.sensorDeg[row]);
    if (!sweep.turn.empty()) {
      text += "," + std::to_string(sweep.turn[row]);
    }
    if (!sweep.direction.empty()) {
      text += "," + std::to_string(sweep.direction[row]);
    }
    if (!sweep.temperatureC.empty()) {
      addGapOrNumber(sweep.temperatureC[row]);
    }
    if (!sweep.timeS.empty()) {
      addGapOrNumber(sweep.timeS[row]);
    }
    text += '\n';
  }
  return text;
}

} // namespace straightedge::angle
