#include "core/angle/sensor_resolution.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace straightedge::angle {

namespace {

bool allOnSteps(const Eigen::VectorXd& readingDeg, double stepDeg) {
  // Readings are often written with a few decimals only: a hundredth of a step is room enough for that.
  constexpr double tolerance = 0.01;
  for (Eigen::Index i = 1; i < readingDeg.size(); ++i) {
    const double steps = (readingDeg(i) - readingDeg(0)) / stepDeg;
    if (std::abs(steps - std::round(steps)) > tolerance) {
      return false;
    }
  }
  return true;
}

std::vector<double> usualStepsFromWide() {
  std::vector<double> steps;
  for (int bits = 6; bits <= 20; ++bits) {
    steps.push_back(std::ldexp(360.0, -bits));
  }
  for (double place = 1.0; place > 5e-7; place /= 10.0) {
    steps.push_back(place);
  }
  std::sort(steps.rbegin(), steps.rend());
  return steps;
}

} // namespace

double estimateResolutionDeg(const Eigen::VectorXd& readingDeg) {
  // Few readings fall on the steps of anything.
  constexpr Eigen::Index fewestReadings = 8;
  if (readingDeg.size() < fewestReadings) {
    return 0.0;
  }
  for (const double step : usualStepsFromWide()) {
    if (allOnSteps(readingDeg, step)) {
      return step;
    }
  }
  return 0.0;
}

} // namespace straightedge::angle
