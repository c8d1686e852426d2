#include "core/field/plateaus.h"

#include "core/base/number_text.h"
#include "core/field/names.h"
#include "core/numerics/statistics.h"

#include <algorithm>
#include <cmath>

namespace straightedge::field {

namespace {

/// Least rows of a plateau where most have more: from fewer a mean says little, and it would shorten all the others.
constexpr Eigen::Index fewRows = 3;
/// Scatter that settled plateaus do not show.
constexpr double unsettledTimesMedian = 20.0;
constexpr double unsettledOfFullScale = 1e-5;

struct Run {
  Eigen::Index first = 0, rows = 0;
  double referenceSigmaT = 0.0, rawSigmaT = 0.0; ///< over all rows of the run
};

template <typename Column>
double deviation(const Column& values) {
  if (values.size() < 2) {
    return 0.0;
  }
  const double mean = values.mean();
  return std::sqrt((values.array() - mean).square().sum() / static_cast<double>(values.size() - 1));
}

std::vector<Run> runsOf(const StepRows& rows) {
  const auto axis = static_cast<Eigen::Index>(indexOf(*rows.axis));
  std::vector<Run> runs;
  for (std::size_t i = 0; i < rows.runBegin.size(); ++i) {
    const Eigen::Index first = rows.runBegin[i];
    const Eigen::Index count = rows.runEnd(i) - first;
    runs.push_back({first, count, deviation(rows.referenceT.segment(first, count)),
                    deviation(rows.rawT.col(axis).segment(first, count))});
  }
  return runs;
}

template <typename Get>
double medianOf(const std::vector<Run>& runs, Get get) {
  std::vector<double> values;
  values.reserve(runs.size());
  for (const Run& run : runs) {
    values.push_back(static_cast<double>(get(run)));
  }
  return numerics::median(std::move(values));
}

std::string milliTesla(double valueT) { return formatForPeople(valueT * 1e3, 2) + " mT"; }

double meanOrEmpty(const Eigen::VectorXd& column, Eigen::Index first, Eigen::Index rows) {
  return column.segment(first, rows).mean(); // one empty cell: not known
}

Plateau averaged(const StepRows& rows, const Run& run, Eigen::Index kept) {
  Plateau plateau;
  plateau.first = run.first;
  plateau.recorded = run.rows;
  plateau.line = rows.line[static_cast<std::size_t>(run.first)];
  const auto reference = rows.referenceT.segment(run.first, kept);
  plateau.referenceT = reference.mean();
  plateau.referenceSigmaT = deviation(reference);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const auto raw = rows.rawT.col(axis).segment(run.first, kept);
    plateau.rawT[axis] = raw.mean();
    plateau.rawSigmaT[axis] = deviation(raw);
  }
  plateau.probeOhm = meanOrEmpty(rows.pt100Ohm, run.first, kept);
  plateau.electronicsC = meanOrEmpty(rows.electronicsC, run.first, kept);
  return plateau;
}

} // namespace

Eigen::VectorXd AxisPlateaus::referenceT() const {
  Eigen::VectorXd values(static_cast<Eigen::Index>(plateaus.size()));
  std::ranges::transform(plateaus, values.begin(), &Plateau::referenceT);
  return values;
}

Eigen::VectorXd AxisPlateaus::rawT(Axis of) const {
  const auto index = static_cast<Eigen::Index>(indexOf(of));
  Eigen::VectorXd values(static_cast<Eigen::Index>(plateaus.size()));
  std::ranges::transform(plateaus, values.begin(), [index](const Plateau& p) { return p.rawT[index]; });
  return values;
}

double AxisPlateaus::noiseT(Axis of) const {
  const auto index = static_cast<Eigen::Index>(indexOf(of));
  numerics::PooledDeviation pooled;
  if (rowsEach < 2) {
    return 0.0;
  }
  for (const Plateau& plateau : plateaus) {
    const double sigma = plateau.rawSigmaT[index];
    pooled.add(sigma * sigma * static_cast<double>(rowsEach - 1), static_cast<std::size_t>(rowsEach));
  }
  return pooled.isKnown() ? std::sqrt(pooled.variance()) : 0.0;
}

AxisPlateaus findPlateaus(const StepRows& rows, double fullScaleT) {
  AxisPlateaus result;
  result.axis = *rows.axis;
  result.unlocked = rows.unlocked;
  result.incomplete = rows.incomplete;
  const std::vector<Run> runs = runsOf(rows);
  const double typicalRows = medianOf(runs, [](const Run& run) { return run.rows; });
  const double typicalReference = medianOf(runs, [](const Run& run) { return run.referenceSigmaT; });
  const double typicalRaw = medianOf(runs, [](const Run& run) { return run.rawSigmaT; });
  const double floorT = unsettledOfFullScale * fullScaleT;
  const auto isUnsettled = [&](double sigma, double typical) {
    return sigma > floorT && sigma > unsettledTimesMedian * typical;
  };

  std::vector<Run> kept;
  for (const Run& run : runs) {
    std::string reason;
    if (run.rows < fewRows && typicalRows > static_cast<double>(fewRows)) {
      reason = "only " + std::to_string(run.rows) + (run.rows == 1 ? " row" : " rows") + " where the others have " +
               formatForPeople(typicalRows, 1);
    } else if (isUnsettled(run.referenceSigmaT, typicalReference)) {
      reason = "the reference is unsettled: it scatters by " + milliTesla(run.referenceSigmaT) +
               ", in the other plateaus by " + milliTesla(typicalReference);
    } else if (isUnsettled(run.rawSigmaT, typicalRaw)) {
      reason = "the reading is unsettled: it scatters by " + milliTesla(run.rawSigmaT) + ", in the other plateaus by " +
               milliTesla(typicalRaw);
    }
    if (reason.empty()) {
      kept.push_back(run);
      continue;
    }
    result.unsettled += static_cast<std::size_t>(run.rows);
    result.rejected.push_back({rows.referenceT.segment(run.first, run.rows).mean(), run.rows,
                               rows.line[static_cast<std::size_t>(run.first)], std::move(reason)});
  }
  if (kept.empty()) {
    return result;
  }
  result.rowsEach = std::ranges::min(kept, {}, &Run::rows).rows;
  for (const Run& run : kept) {
    result.plateaus.push_back(averaged(rows, run, result.rowsEach));
    result.surplus += static_cast<std::size_t>(run.rows - result.rowsEach);
  }
  return result;
}

} // namespace straightedge::field
