// PT100 resistance to probe temperature: a line from a chamber that is swept up and down twice (Electronics 2020, 9,
// 151, section 5.2.1, Figure 7).
#pragma once

#include "core/base/error.h"
#include "core/field/block_report.h"
#include "core/field/calibration.h"
#include "core/field/step_rows.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace straightedge::field {

struct ProbeTemperatureReport {
  BlockReport block; ///< slope and intercept in this order; residuals in °C (chamber − line)
  Pt100Line line;
  Pt100Line plainLine; ///< without regard to the lag; the same where none was estimated
  double spanC = 0.0;  ///< chamber temperatures covered
  /// Mean width of the loop between heating and cooling, in °C at equal resistance; nothing without both directions.
  std::optional<double> hysteresisC;
  std::optional<double> largestHysteresisC; ///< where the loop is widest
  std::optional<double> loopLeftC;          ///< mean width of what remains of the loop once the lag is taken away
  /// Time constant with which the probe follows the chamber; nothing where no times were recorded or the fit finds
  /// none.
  std::optional<double> lagS;
  std::string lagText; ///< "no times: lag not estimated", or how it was found
  /// Standard uncertainty of a temperature read off the line, in °C: the scatter about it, in which the loop shows as
  /// far as no lag takes it away, and the line's own where that is largest.
  double standardUncertaintyC = 0.0;
  // For the plot, row by row; temperatures minus reference temperature
  Eigen::VectorXd ohm, chamberC, lineC;
  Eigen::VectorXd feltC;       ///< chamber temperature as the probe felt it: behind the lag; without one, chamberC
  std::vector<int> directions; ///< of the chamber: +1 heating, −1 cooling, 0 not known
};

/// Of a loop this much of the sweep, the lag was a large part of a cycle: slope and lag are hard to tell apart, and the
/// result says that the chamber should be swept more slowly.
inline constexpr double wideLoop = 0.3;

/// Least squares of (chamber − reference temperature) over resistance. Where times are recorded the chamber temperature
/// first runs through a first-order lag whose time constant leaves the least residual: a probe that trails the chamber
/// then does not tilt the line.
/// Errors (Input): too few rows; a chamber or a PT100 that does not move; resistance that falls with temperature.
Result<ProbeTemperatureReport> fitProbeTemperature(const StepRows& rows, double referenceTemperatureC,
                                                   const std::string& name);

} // namespace straightedge::field
