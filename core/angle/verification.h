// A fresh sweep through a chosen model: does the corrected angle stay within the limit?
#pragma once

#include "core/angle/calibration.h"

#include <cstdint>
#include <vector>

namespace straightedge::angle {

enum class Verdict : std::uint8_t { Pass, Fail, PassWithinUncertainty, FailWithinUncertainty };

struct VerificationReport {
  std::string model;
  double limitDeg = 0.0;
  double maxErrorDeg = 0.0; ///< largest |wrapped error| over the sweep's points, after correction
  double rmsErrorDeg = 0.0;
  double maxErrorBeforeDeg = 0.0; ///< the same of the raw sensor, best constant offset not removed
  double rmsErrorBeforeDeg = 0.0;
  std::size_t points = 0;
  double expandedUncertaintyDeg = 0.0; ///< of the corrected angle, from the calibration; 0 = not known
  bool met = false;                    ///< maxErrorDeg ≤ limitDeg: the decision (simple acceptance), exit code 0 or 1
  Verdict verdict = Verdict::Fail;     ///< …WithinUncertainty where |maxError − limit| < expanded uncertainty
  std::string decisionRule;            ///< a sentence that says how uncertainty counts
  // For plots, in the sweep's order
  std::vector<double> encoderDeg;
  std::vector<double> errorBeforeDeg;
  std::vector<double> errorAfterDeg;
};

/// Errors: those of a sweep that cannot be read as numbers; an empty sweep; limit not positive (Usage).
Result<VerificationReport> verify(const AngleCalibration& calibration, const Model& model, const Sweep& fresh,
                                  double limitDeg);

} // namespace straightedge::angle
