// Does a step hold enough for a line over a temperature? Private to the blocks.
#pragma once

#include "core/base/error.h"
#include "core/field/step_rows.h"

#include <Eigen/Core>

#include <string>

namespace straightedge::field {

/// Rows of a line; two would do for the line and say nothing of its error.
inline constexpr Eigen::Index leastRows = 4;
/// A temperature that covers less has not been moved.
inline constexpr double leastSpanC = 1.0;

/// Errors (Input): no rows, or fewer than leastRows, with the reason that rows were left out.
Result<void> checkRowCount(const StepRows& rows, const std::string& name);

/// Errors (Input): `temperatureC` of `thing` ("probe", "electronics", "chamber") covers less than leastSpanC.
Result<void> checkSpan(const Eigen::VectorXd& temperatureC, const std::string& thing, const std::string& step,
                       const std::string& name);

} // namespace straightedge::field
