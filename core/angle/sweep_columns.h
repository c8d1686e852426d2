// What the titles of a CSV file's columns mean for a sweep. Private to sweep_csv.
#pragma once

#include "core/angle/sweep_csv.h"

#include <string_view>

namespace straightedge::angle {

/// Role of every column; without a header the first two columns, if there are only two.
SweepMapping guessMapping(const CsvTable& table);

/// Errors: those that readSweepCsv() states for columns. Where = the table's name.
Result<void> checkMapping(const CsvTable& table, const SweepMapping& mapping);

/// +1 or −1 for a number (by its sign) or a word such as "up" or "ccw"; nothing for anything else.
std::optional<int> parseDirection(std::string_view text, char decimalPoint);

} // namespace straightedge::angle
