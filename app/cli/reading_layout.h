// Which column of a table of readings holds the sensor angle.
#pragma once

#include "core/base/csv_table.h"
#include "core/base/error.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace straightedge::cli {

struct ReadingLayout {
  CsvLayout csv;
  std::size_t columns = 1;
  std::size_t sensorColumn = 0;
};

/// Looks at the first rows of `start`, which ends at the end of a line or of the file. The sensor's column is called
/// sensor_deg, or is recognised as in a sweep (sensor, measured), or is the only column of numbers.
/// Errors (Input, where = name): those of CsvTable; no such column; a column corrected_deg that is there already.
Result<ReadingLayout> findReadingLayout(std::string_view start, const std::string& name);

} // namespace straightedge::cli
