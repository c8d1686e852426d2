#include "app/cli/reading_layout.h"

#include "core/angle/sweep_columns.h"

#include <algorithm>

namespace straightedge::cli {

namespace {

constexpr std::size_t rowsLookedAt = 256;

/// The first lines of a text; all of it if it has fewer.
std::string_view firstLines(std::string_view text, std::size_t count) {
  std::size_t end = 0;
  for (std::size_t line = 0; line < count && end != std::string_view::npos; ++line) {
    end = text.find('\n', end);
    end = end == std::string_view::npos ? end : end + 1;
  }
  return text.substr(0, end);
}

bool isColumnOfNumbers(const CsvTable& table, std::size_t column) {
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (!table.numberIfAny(row, column)) {
      return false;
    }
  }
  return true;
}

} // namespace

Result<CsvTable> firstReadings(std::string_view start, const std::string& name) {
  return CsvTable::parse(std::string(firstLines(start, rowsLookedAt)), name);
}

ReadingLayout layoutOf(const CsvTable& table) { return {table.layout(), table.columns(), {}}; }

Result<void> refuseColumn(const CsvTable& table, std::string_view title) {
  for (std::size_t column = 0; column < table.columns(); ++column) {
    if (table.title(column) == title) {
      return fail(ErrorKind::Input, "there is a column " + std::string(title) + " already",
                  "rename it or apply to the raw readings", table.name());
    }
  }
  return {};
}

Result<ReadingLayout> findAngleReadings(std::string_view start, const std::string& name) {
  const auto table = firstReadings(start, name);
  if (!table) {
    return std::unexpected(table.error());
  }
  if (auto free = refuseColumn(*table, "corrected_deg"); !free) {
    return std::unexpected(std::move(free.error()));
  }
  ReadingLayout layout = layoutOf(*table);
  std::vector<std::size_t> named;
  std::vector<std::size_t> recognised;
  std::vector<std::size_t> numeric;
  const angle::SweepMapping mapping = angle::guessMapping(*table);
  for (std::size_t column = 0; column < table->columns(); ++column) {
    if (table->title(column) == "sensor_deg") {
      named.push_back(column);
    }
    if (table->layout().hasHeader && mapping[column] == angle::SweepColumn::Sensor) {
      recognised.push_back(column);
    }
    if (isColumnOfNumbers(*table, column)) {
      numeric.push_back(column);
    }
  }
  for (const auto& candidates : {named, recognised, table->columns() == 1 ? std::vector<std::size_t>{0} : numeric}) {
    if (candidates.size() == 1) {
      layout.wanted.push_back({candidates.front(), 0, "sensor angle"});
      return layout;
    }
  }
  return fail(ErrorKind::Input,
              "there is no column sensor_deg and " +
                  (numeric.empty() ? "no column of numbers" : std::to_string(numeric.size()) + " columns of numbers"),
              "name the column of readings sensor_deg", name);
}

} // namespace straightedge::cli
