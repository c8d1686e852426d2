// Sweeps from and to CSV files: the recorded rows as they are, nothing judged but whether they are numbers.
#pragma once

#include "core/angle/sweep.h"
#include "core/base/csv_table.h"
#include "core/base/error.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace straightedge::angle {

/// How a column of a CSV file is understood.
enum class SweepColumn : std::uint8_t { Ignored, Encoder, Sensor, Turn, Direction, Temperature, Time };

const char* sweepColumnTitle(SweepColumn column); ///< canonical title: "encoder_deg", …; "" for Ignored

/// One entry per column of the file.
using SweepMapping = std::vector<SweepColumn>;

/// What an import dialogue shows before the sweep is read.
struct CsvPreview {
  struct Column {
    std::string title; ///< as in the file; "column 2" without a header
    SweepColumn role = SweepColumn::Ignored;
    std::optional<double> minimum, maximum; ///< of the column's numbers; absent where it has none
  };
  CsvLayout layout;
  std::vector<Column> columns;
  std::vector<std::vector<std::string>> firstRows; ///< at most 50, as text
  std::size_t rowCount = 0;
  std::optional<Error> problem; ///< why the sweep cannot be read with these roles: choose others

  SweepMapping mapping() const;
};

/// Looks at a file without reading the sweep. `path` or "-". Any thread. Errors: those of CsvTable.
Result<CsvPreview> inspectCsv(const std::string& path);

/// Reads a sweep. Columns are recognised by their titles (encoder or reference; sensor or measured; turn, direction,
/// temperature, time; any case, units in brackets), or by `mapping`; without titles there are two columns of numbers,
/// encoder then sensor. Fills source and line. NaN, infinity and values out of range are left to alignSweep().
/// `path` or "-". Errors (Input): those of CsvTable; no column, or two, for the encoder or sensor; an angle in another
/// unit than degrees; text that is no number (FILE:LINE). (Usage): a mapping that does not fit the file.
Result<Sweep> readSweepCsv(const std::string& path, const std::optional<SweepMapping>& mapping = std::nullopt);

/// The same from bytes already read; `name` for messages, `fileName` for the source record.
Result<Sweep> parseSweepCsv(std::string bytes, const std::string& name, const std::string& fileName,
                            const std::optional<SweepMapping>& mapping = std::nullopt);

/// Canonical CSV: `encoder_deg,sensor_deg` and the optional columns that the sweep has. Rows that are switched off are
/// left out. Numbers read back to the same doubles.
std::string sweepToCsv(const Sweep& sweep);

} // namespace straightedge::angle
