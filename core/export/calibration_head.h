// What calibration.json holds of every kind of calibration: format, version, kind, when, by what, of what.
// Private to the .cpp files of core/export.
#pragma once

#include "core/base/json_writer.h"
#include "core/base/traceability.h"
#include "core/export/json_reader.h"

#include <string>
#include <string_view>

namespace straightedge::exporting {

struct CalibrationHead {
  std::string created;
  std::string software;
  SourceRecord source;
  Traceability traceability;
};

void writeCalibrationHead(JsonWriter& json, std::string_view kind, const CalibrationHead& head);

/// Blames the reader for a file that is no calibration, of a later version, or not of this kind ("angle", "field").
CalibrationHead readCalibrationHead(JsonReader& reader, const JsonNode& root, std::string_view kind);

} // namespace straightedge::exporting
