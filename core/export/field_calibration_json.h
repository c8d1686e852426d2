// calibration.json of a field calibration, both ways.
#pragma once

#include "core/base/error.h"
#include "core/field/calibration.h"

#include <string>
#include <string_view>

namespace straightedge::exporting {

/// The file's text. Numbers are written with the digits that read back to the same double. Beside the published keys
/// it holds how the calibration was made: `method`, `nonlinearity_order`, `order_explanation`, `blocks`, `probe`,
/// `verification_stages` (the states between uncalibrated and calibrated, and after the axis matrix), cross-validated
/// errors beside `nonlinearity_orders`, `joint_fit` and `verification_stepwise` of a joint fit, percent of reading
/// beside `verification`, `axis_angles_deg`, and `warnings`.
std::string fieldCalibrationToJson(const field::FieldCalibration& calibration);

/// Does this text say that it is a calibration of kind field? False for anything else, JSON or not.
bool isFieldCalibration(std::string_view text);

/// Reads what fieldCalibrationToJson() wrote, and files of others that hold the published keys; unknown keys are passed
/// over, blocks that are null or absent are off.
/// Errors (Input): no JSON (FILE:LINE); another format, version or kind; a key that is missing, of the wrong type or
/// out of range, named by its path such as axes.y.offset_T; a list of coefficients of the wrong length; a block over
/// probe temperature without pt100; a matrix that is singular.
Result<field::FieldCalibration> fieldCalibrationFromJson(std::string_view text, const std::string& name);

/// The same from a file, or from standard input if `path` is "-".
Result<field::FieldCalibration> readFieldCalibration(const std::string& path);

} // namespace straightedge::exporting
