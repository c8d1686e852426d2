#include "core/angle/sweep_checks.h"

#include "core/angle/angles.h"
#include "core/angle/messages.h"
#include "core/base/number_text.h"
#include "core/numerics/statistics.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace straightedge::angle {

namespace {

constexpr std::size_t fewestAngles = 8;
constexpr std::size_t comfortableAngles = 16;
constexpr std::size_t anglesForWideSwing = 32;
constexpr double wideSwingDeg = 5.0;
constexpr double widestGapDeg = 90.0;
/// Ten thousand turns: no sweep is longer, and angles keep nine decimals of a degree up to there.
constexpr double largestEncoderDeg = 3600000.0;
/// A gap narrower than this hides nothing that 64 harmonics could show, however dense the other points are.
constexpr double gapWorthNamingDeg = 1.0;

/// A place on the circle: one more digit than a width needs.
std::string place(double value) { return formatForPeople(value, 4) + "°"; }
/// A limit, as it is written here.
std::string limit(double value) { return formatDouble(value) + "°"; }

std::string rowPlace(const Sweep& sweep, std::size_t row) {
  if (row < sweep.line.size()) {
    return sweep.source.file + ":" + std::to_string(sweep.line[row]);
  }
  return sweep.source.file;
}

/// Without a file's line the row's number has to say which one.
std::string rowNote(const Sweep& sweep, std::size_t row) {
  return row < sweep.line.size() ? std::string() : " in row " + std::to_string(row + 1);
}

std::optional<Error> refuseNumber(const Sweep& sweep, std::size_t row, const char* name, double value, double low,
                                  double high) {
  if (!std::isfinite(value)) {
    return Error{ErrorKind::Input,
                 "the " + std::string(name) + " angle" + rowNote(sweep, row) + " is not a finite number (" +
                     formatDouble(value) + ")",
                 "remove the row or switch it off", rowPlace(sweep, row)};
  }
  if (value < low || value > high) {
    return Error{ErrorKind::Input,
                 "the " + std::string(name) + " angle " + formatDouble(value) + "°" + rowNote(sweep, row) +
                     " is outside " + limit(low) + " to " + limit(high),
                 "give angles in degrees, or remove the row", rowPlace(sweep, row)};
  }
  return std::nullopt;
}

struct Gap {
  double fromDeg = 0.0;
  double widthDeg = 0.0;
};

/// Gaps round the circle between ascending angles; one for each angle, the last reaching back to the first.
std::vector<Gap> gapsRound(const Eigen::VectorXd& ascendingDeg) {
  std::vector<Gap> gaps;
  gaps.reserve(static_cast<std::size_t>(ascendingDeg.size()));
  for (Eigen::Index i = 0; i < ascendingDeg.size(); ++i) {
    const bool last = i + 1 == ascendingDeg.size();
    const double next = last ? ascendingDeg(0) + 360.0 : ascendingDeg(i + 1);
    gaps.push_back({ascendingDeg(i), next - ascendingDeg(i)});
  }
  return gaps;
}

Gap widest(const std::vector<Gap>& gaps) {
  return *std::max_element(gaps.begin(), gaps.end(),
                           [](const Gap& a, const Gap& b) { return a.widthDeg < b.widthDeg; });
}

std::string stretch(double fromDeg, double widthDeg) {
  return place(fromDeg) + " to " + place(wrap360(fromDeg + widthDeg));
}

} // namespace

std::optional<Error> refuseUnreadable(const Sweep& sweep) {
  const std::size_t rows = sweep.encoderDeg.size();
  const auto fits = [&](std::size_t length) { return length == 0 || length == rows; };
  if (sweep.sensorDeg.size() != rows || !fits(sweep.turn.size()) || !fits(sweep.direction.size()) ||
      !fits(sweep.enabled.size())) {
    return sweepError(sweep, "the sweep's columns differ in length", "give every row a value in every column");
  }
  for (std::size_t row = 0; row < rows; ++row) {
    if (!sweep.isEnabled(row)) {
      continue;
    }
    if (auto error =
            refuseNumber(sweep, row, "encoder", sweep.encoderDeg[row], -largestEncoderDeg, largestEncoderDeg)) {
      return error;
    }
    if (auto error = refuseNumber(sweep, row, "sensor", sweep.sensorDeg[row], 0.0, 360.0)) {
      return error;
    }
  }
  return std::nullopt;
}

std::optional<Error> refuseCoverage(const Sweep& sweep, const Eigen::VectorXd& distinctEncoderDeg) {
  const auto angles = static_cast<std::size_t>(distinctEncoderDeg.size());
  if (angles < fewestAngles) {
    return sweepError(sweep,
                      "only " + std::to_string(angles) + " distinct encoder angles; a calibration needs at least " +
                          std::to_string(fewestAngles),
                      "record more angles, spread over the whole turn");
  }
  const Gap gap = widest(gapsRound(distinctEncoderDeg));
  if (gap.widthDeg > widestGapDeg) {
    return sweepError(sweep,
                      "no encoder angle in the " + degreesText(gap.widthDeg) + " from " +
                          stretch(gap.fromDeg, gap.widthDeg) + "; gaps up to " + limit(widestGapDeg) + " are accepted",
                      "record the missing part of the turn");
  }
  return std::nullopt;
}

std::optional<Error> measureGaps(const Sweep& sweep, const Eigen::VectorXd& distinctReadingDeg, AlignedSweep& aligned) {
  const std::vector<Gap> gaps = gapsRound(distinctReadingDeg);
  std::vector<double> widths(gaps.size());
  std::transform(gaps.begin(), gaps.end(), widths.begin(), [](const Gap& gap) { return gap.widthDeg; });
  aligned.medianGapDeg = numerics::median(std::move(widths));
  const bool mirrored = aligned.direction == SensorDirection::Decreasing;
  const auto asSensor = [&](const Gap& gap) {
    return mirrored ? wrap360(360.0 - gap.fromDeg - gap.widthDeg) : gap.fromDeg;
  };
  const Gap largest = widest(gaps);
  aligned.largestGapDeg = largest.widthDeg;
  if (largest.widthDeg > widestGapDeg) {
    return sweepError(sweep,
                      "the sensor leaps over " + degreesText(largest.widthDeg) + ", from " +
                          stretch(asSensor(largest), largest.widthDeg) + ", between neighbouring points; gaps up to " +
                          limit(widestGapDeg) + " are accepted",
                      "record more angles where the sensor moves fast");
  }
  for (const Gap& gap : gaps) {
    if (gap.widthDeg > 2.0 * aligned.medianGapDeg && gap.widthDeg > gapWorthNamingDeg) {
      aligned.gaps.push_back({asSensor(gap), gap.widthDeg});
    }
  }
  return std::nullopt;
}

void noteWarnings(AlignedSweep& aligned) {
  const auto warn = [&](Warning::Topic topic, std::string text) {
    aligned.warnings.push_back({topic, std::move(text)});
  };
  const double swing = aligned.correctionDeg.maxCoeff() - aligned.correctionDeg.minCoeff();
  const std::string count = std::to_string(aligned.distinctAngles);
  if (aligned.distinctAngles < comfortableAngles) {
    warn(Warning::Topic::FewAngles,
         "Only " + count + " distinct angles: at least " + std::to_string(comfortableAngles) + " are recommended.");
  }
  if (aligned.distinctAngles < anglesForWideSwing && swing > wideSwingDeg) {
    warn(Warning::Topic::FewAnglesForSwing, "The correction swings by " + degreesText(swing) + ", but there are only " +
                                                count + " distinct angles: above " + limit(wideSwingDeg) +
                                                " at least " + std::to_string(anglesForWideSwing) +
                                                " are recommended.");
  }
  if (!aligned.gaps.empty()) {
    const auto wide =
        *std::max_element(aligned.gaps.begin(), aligned.gaps.end(),
                          [](const CoverageGap& a, const CoverageGap& b) { return a.widthDeg < b.widthDeg; });
    std::string text = aligned.gaps.size() == 1
                           ? "A gap in the sensor angles of " + degreesText(wide.widthDeg)
                           : std::to_string(aligned.gaps.size()) + " gaps in the sensor angles, the widest " +
                                 degreesText(wide.widthDeg);
    text += " from " + stretch(wide.fromDeg, wide.widthDeg) + ": more than twice the median distance of " +
            degreesText(aligned.medianGapDeg) + "; the correction is uncertain there.";
    warn(Warning::Topic::CoverageGap, std::move(text));
  }
  if (aligned.direction == SensorDirection::Decreasing) {
    warn(Warning::Topic::SensorRunsBackwards, "The sensor's angle falls while the encoder's rises: it is corrected as "
                                              "360° minus the reading.");
  }
}

} // namespace straightedge::angle
