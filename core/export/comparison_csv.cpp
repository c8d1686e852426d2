#include "core/base/csv_table.h"
#include "core/base/number_text.h"
#include "core/export/tables.h"

#include <array>

namespace straightedge::exporting {

namespace {

using namespace angle;

constexpr std::array<const char*, 8> titles{"model", "method",        "size",          "storage_entries",
                                            "bytes", "max_error_deg", "rms_error_deg", "max_error_65536_deg"};
enum Column : std::size_t {
  ColumnModel,
  ColumnMethod,
  ColumnSize,
  ColumnEntries,
  ColumnBytes,
  ColumnMax,
  ColumnRms,
  ColumnFine
};

/// Where each title stands in the file; checked once.
Result<std::array<std::size_t, 8>> findColumns(const CsvTable& table) {
  std::array<std::size_t, 8> found{};
  for (std::size_t i = 0; i < titles.size(); ++i) {
    std::size_t column = 0;
    while (column < table.columns() && table.title(column) != titles[i]) {
      ++column;
    }
    if (column == table.columns()) {
      return fail(ErrorKind::Input, std::string("there is no column ") + titles[i],
                  "write the file anew with straightedge-cli angle compare", table.name());
    }
    found[i] = column;
  }
  return found;
}

Result<ModelName> readName(const CsvTable& table, std::size_t row, const std::array<std::size_t, 8>& columns) {
  std::string text(table.cell(row, columns[ColumnModel]));
  text += ":" + std::string(table.cell(row, columns[ColumnSize]));
  text += "@" + std::string(table.cell(row, columns[ColumnMethod]));
  auto name = parseModelName(text);
  if (!name) {
    return fail(ErrorKind::Input, name.error().what, name.error().remedy, table.where(row));
  }
  return name;
}

Result<ComparisonRow> readRow(const CsvTable& table, std::size_t row, const std::array<std::size_t, 8>& columns) {
  const auto name = readName(table, row, columns);
  if (!name) {
    return std::unexpected(name.error());
  }
  ComparisonRow entry;
  entry.name = *name;
  std::array<double, 4> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto number = table.number(row, columns[ColumnEntries + i]);
    if (!number) {
      return std::unexpected(number.error());
    }
    numbers[i] = *number;
  }
  entry.storageEntries = static_cast<int>(numbers[0]);
  entry.bytes = static_cast<int>(numbers[1]);
  entry.maxErrorDeg = numbers[2];
  entry.rmsErrorDeg = numbers[3];
  if (!table.cell(row, columns[ColumnFine]).empty()) {
    const auto fine = table.number(row, columns[ColumnFine]);
    if (!fine) {
      return std::unexpected(fine.error());
    }
    entry.maxErrorFineDeg = *fine;
  }
  return entry;
}

} // namespace

std::string comparisonCsv(const Comparison& comparison) {
  std::string text;
  for (const char* title : titles) {
    text += (text.empty() ? "" : ",") + std::string(title);
  }
  text += '\n';
  for (const ComparisonRow& row : comparison.rows) {
    text += std::string(kindText(row.name.kind)) + "," + methodText(row.name.method) + "," +
            std::to_string(row.name.size) + "," + std::to_string(row.storageEntries) + "," + std::to_string(row.bytes) +
            "," + formatDouble(row.maxErrorDeg) + "," + formatDouble(row.rmsErrorDeg) + "," +
            (row.maxErrorFineDeg ? formatDouble(*row.maxErrorFineDeg) : std::string()) + "\n";
  }
  return text;
}

Result<Comparison> comparisonFromCsv(std::string bytes, const std::string& name) {
  const auto table = CsvTable::parse(std::move(bytes), name);
  if (!table) {
    return std::unexpected(table.error());
  }
  const auto columns = findColumns(*table);
  if (!columns) {
    return std::unexpected(columns.error());
  }
  Comparison comparison;
  for (std::size_t row = 0; row < table->rows(); ++row) {
    const auto entry = readRow(*table, row, *columns);
    if (!entry) {
      return std::unexpected(entry.error());
    }
    comparison.rows.push_back(*entry);
  }
  return comparison;
}

} // namespace straightedge::exporting
