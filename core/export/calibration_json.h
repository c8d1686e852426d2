// calibration.json of an angle calibration, both ways.
#pragma once

#include "core/angle/calibration.h"
#include "core/base/error.h"

#include <string>
#include <string_view>

namespace straightedge::exporting {

inline constexpr int calibrationFormatVersion = 1;

/// The file's text. Numbers are written with the digits that read back to the same double. Beside the published keys
/// it holds `curve` (how the correction curve was made), `repeatability`, `gaps` and `warnings`; keys without content
/// are left out. The per-angle lists of `passes` are not part of the file: they follow from the sweep.
std::string calibrationToJson(const angle::AngleCalibration& calibration);

/// Reads what calibrationToJson() wrote, and files of others that hold the published keys; unknown keys are passed
/// over. `name` stands in messages.
/// Errors (Input): no JSON (FILE:LINE); another format, version or kind; a key that is missing, of the wrong type or
/// out of range, named by its path such as models[1].values_deg; a model whose values do not fit its name; no models.
Result<angle::AngleCalibration> calibrationFromJson(std::string_view text, const std::string& name);

/// The same from a file, or from standard input if `path` is "-".
Result<angle::AngleCalibration> readCalibration(const std::string& path);

/// The model of this name, or the first one without a name.
/// Errors (Usage): there is no such model; the message lists those there are.
Result<const angle::Model*> findModel(const angle::AngleCalibration& calibration, std::string_view name,
                                      const std::string& file);

} // namespace straightedge::exporting
