// Which columns of a table of readings are to be read.
#pragma once

#include "core/base/csv_table.h"
#include "core/base/error.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace straightedge::cli {

struct WantedColumn {
  std::size_t column = 0;
  std::size_t value = 0; ///< where its number goes
  std::string meaning;   ///< for messages: "sensor angle"
};

struct ReadingLayout {
  CsvLayout csv;
  std::size_t columns = 1;
  std::vector<WantedColumn> wanted; ///< by ascending column
};

/// The first rows of `start`, which ends at the end of a line or of the file. Errors: those of CsvTable.
Result<CsvTable> firstReadings(std::string_view start, const std::string& name);

/// The layout of `table`, in which nothing is wanted yet.
ReadingLayout layoutOf(const CsvTable& table);

/// Errors (Input): the table has a column `title` already, which is to be added.
Result<void> refuseColumn(const CsvTable& table, std::string_view title);

/// The sensor's column is called sensor_deg, or is recognised as in a sweep (sensor, measured), or is the only column
/// of numbers. Errors (Input, where = name): those of firstReadings(); no such column; a column corrected_deg that is
/// there already.
Result<ReadingLayout> findAngleReadings(std::string_view start, const std::string& name);

} // namespace straightedge::cli
