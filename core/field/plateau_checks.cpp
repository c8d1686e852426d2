#include "core/field/plateau_checks.h"

#include "core/field/messages.h"
#include "core/field/names.h"

#include <algorithm>
#include <cmath>

namespace straightedge::field {

namespace {

/// Below this share of the largest field an offset may turn the sign of a reading.
constexpr double signIsCertain = 0.05;
/// Two plateaus of one field may differ by as much, of full scale: hysteresis, drift. More is a contradiction.
constexpr double samePlateau = 0.01;

std::string labelOf(Axis axis) { return "axis " + std::string(axisName(axis)) + ": "; }

Result<void> checkEnough(const AxisPlateaus& plateaus, int order, const std::string& name) {
  const std::size_t wanted = static_cast<std::size_t>(order) + 2;
  if (plateaus.plateaus.size() >= wanted) {
    return {};
  }
  std::string what = labelOf(plateaus.axis);
  if (plateaus.plateaus.empty() && plateaus.rejected.empty()) {
    return campaignFault(name, 0,
                         what + "the reference was never locked in the " + counted(plateaus.unlocked, "row") +
                             " of the step nonlinearity",
                         "check the reference's probe and range and record the step again");
  }
  what += "only " + counted(plateaus.plateaus.size(), "plateau") + " of the step nonlinearity can be used, order " +
          std::to_string(order) + " needs " + std::to_string(wanted);
  if (!plateaus.rejected.empty()) {
    what += " (" + std::to_string(plateaus.rejected.size()) + " rejected: " + plateaus.rejected.front().reason + ")";
  }
  return campaignFault(name, 0, std::move(what), "record plateaus at more fields, or choose a lower --order");
}

Result<void> checkBothSigns(const AxisPlateaus& plateaus, const std::string& name) {
  const Eigen::VectorXd reference = plateaus.referenceT();
  if (reference.minCoeff() < 0.0 && reference.maxCoeff() > 0.0) {
    return {};
  }
  return campaignFault(name, 0,
                       labelOf(plateaus.axis) + "fields of one sign only, from " + teslaText(reference.minCoeff()) +
                           " to " + teslaText(reference.maxCoeff()),
                       "record plateaus of both signs; a negative field has a negative reference_T");
}

Result<void> checkSigns(const AxisPlateaus& plateaus, const std::string& name) {
  const auto axis = static_cast<Eigen::Index>(indexOf(plateaus.axis));
  const double certainT = signIsCertain * plateaus.referenceT().cwiseAbs().maxCoeff();
  const std::string title = "raw_" + std::string(axisName(plateaus.axis)) + "_T";
  for (const Plateau& plateau : plateaus.plateaus) {
    if (std::abs(plateau.referenceT) < certainT) {
      continue;
    }
    if (std::abs(plateau.rawT[axis]) < signIsCertain * std::abs(plateau.referenceT)) {
      return campaignFault(name, plateau.line,
                           title + " reads " + teslaText(plateau.rawT[axis]) + " in a field of " +
                               teslaText(plateau.referenceT),
                           "check that the axis of these rows is the one that points along the field");
    }
    if ((plateau.rawT[axis] < 0.0) != (plateau.referenceT < 0.0)) {
      return campaignFault(name, plateau.line,
                           title + " reads " + teslaText(plateau.rawT[axis]) + " in a field of " +
                               teslaText(plateau.referenceT) + ": the signs contradict each other",
                           "give reference_T the sign of the field, along the axis");
    }
  }
  return {};
}

Result<void> checkRepeats(const AxisPlateaus& plateaus, double fullScaleT, const std::string& name) {
  const auto axis = static_cast<Eigen::Index>(indexOf(plateaus.axis));
  std::vector<Plateau> sorted = plateaus.plateaus;
  std::ranges::sort(sorted, {}, &Plateau::referenceT);
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    const Plateau& a = sorted[i - 1];
    const Plateau& b = sorted[i];
    const double stepT = b.referenceT - a.referenceT;
    const double apartT = b.rawT[axis] - a.rawT[axis];
    if (stepT <= plateauToleranceT && std::abs(apartT - stepT) > samePlateau * fullScaleT) {
      const Plateau& later = a.first > b.first ? a : b;
      const Plateau& earlier = a.first > b.first ? b : a;
      return campaignFault(name, later.line,
                           "the reading is " + teslaText(later.rawT[axis]) + " in a field of " +
                               teslaText(later.referenceT) + ", but it was " + teslaText(earlier.rawT[axis]) +
                               " before in the same field" +
                               (earlier.line > 0 ? " (line " + std::to_string(earlier.line) + ")" : ""),
                           "remove the plateau that is wrong");
    }
  }
  return {};
}

} // namespace

Result<void> checkPlateaus(const AxisPlateaus& plateaus, const NonlinearityOptions& options, const std::string& name) {
  if (auto done = checkEnough(plateaus, options.order, name); !done) {
    return done;
  }
  if (auto done = checkBothSigns(plateaus, name); !done) {
    return done;
  }
  if (auto done = checkSigns(plateaus, name); !done) {
    return done;
  }
  return checkRepeats(plateaus, options.fullScaleT, name);
}

} // namespace straightedge::field
